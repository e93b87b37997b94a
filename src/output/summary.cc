// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/output/summary.h>

#include <charconv>
#include <cmath>
#include <cstdio>

namespace hybrid::output
{
  namespace
  {
    std::string quoted(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        if (c == '"' || c == '\\')
          result += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
          {
            char code[8];
            std::snprintf(code, sizeof(code), "\\u%04x", static_cast<unsigned>(c));
            result += code;
          }
        else
          result += c;
      return result + "\"";
    }


    /// The shortest text that reads back as the same number; JSON has no NaN and no infinity.
    std::string value(const double number)
    {
      if (!std::isfinite(number))
        return "null";
      char       text[40];
      const auto end = std::to_chars(text, text + sizeof(text), number).ptr;
      return std::string(text, end);
    }

    std::string value(const long number)
    {
      return std::to_string(number);
    }

    std::string value(const bool flag)
    {
      return flag ? "true" : "false";
    }

    std::string value(const std::string &text)
    {
      return quoted(text);
    }

    std::string value(const std::array<double, 2> &pair)
    {
      return "[" + value(pair[0]) + ", " + value(pair[1]) + "]";
    }


    /// A JSON object under construction, one member per line.
    class Object
    {
    public:
      explicit Object(const int depth)
        : indent(2 * depth, ' ')
      {}

      template <typename Value>
      void add(const std::string &key, const Value &member)
      {
        add_text(key, value(member));
      }

      void add(const std::string &key, const Object &member)
      {
        add_text(key, member.text());
      }

      std::string text() const
      {
        return members.empty() ? "{}" : "{\n" + members + "\n" + indent + "}";
      }

    private:
      void add_text(const std::string &key, const std::string &json)
      {
        members += (members.empty() ? "" : ",\n") + indent + "  " + quoted(key) + ": " + json;
      }

      std::string indent;
      std::string members;
    };


    Object numbers(const std::map<std::string, double> &values, const int depth)
    {
      Object object(depth);
      for (const auto &[name, number] : values)
        object.add(name, number);
      return object;
    }


    Object joints(const Summary &summary)
    {
      Object in_static_stage(2);
      in_static_stage.add("tensile", summary.static_joints.tensile);
      in_static_stage.add("shear", summary.static_joints.shear);
      Object object(1);
      object.add("tensile", summary.joints.tensile);
      object.add("shear", summary.joints.shear);
      object.add("static", in_static_stage);
      object.add("first_failure_time_s", summary.first_failure_time);
      return object;
    }


    Object slip(const Summary &summary)
    {
      Object object(1);
      object.add("mean", summary.slip.mean);
      object.add("largest", summary.slip.largest);
      object.add("largest_at", summary.slip.where);
      object.add("mean_left", summary.slip.mean_left);
      object.add("largest_left", summary.slip.largest_left);
      return object;
    }


    Object contact_search(const Summary &summary)
    {
      Object object(1);
      object.add("steps", summary.contact_search.steps);
      object.add("searches", summary.contact_search.searches);
      object.add("lists", summary.contact_search.lists);
      return object;
    }


    Object monitor(const MonitorSummary &monitor)
    {
      Object object(2);
      object.add("peak_displacement_m", monitor.peak_displacement);
      object.add("peak_velocity_m_s", monitor.peak_velocity);
      object.add("peak_acceleration_m_s2", monitor.peak_acceleration);
      object.add("final_displacement_m", monitor.final_displacement);
      object.add("amplification", monitor.amplification);
      object.add("amplification_until_first_failure", monitor.amplification_until_first_failure);
      return object;
    }
  } // namespace



  std::string to_json(const Summary &summary)
  {
    Object monitors(1);
    for (const auto &[name, values] : summary.monitors)
      monitors.add(name, monitor(values));

    Object object(0);
    object.add("title", summary.title);
    object.add("finished", summary.finished);
    object.add("steps", summary.steps);
    object.add("simulated_time_s", summary.simulated_time);
    object.add("wall_time_s", summary.wall_time);
    object.add("peak_memory_mb", summary.peak_memory);
    object.add("blocks", summary.blocks);
    object.add("continuum_unknowns", summary.continuum_unknowns);
    object.add("interface_unknowns", summary.interface_unknowns);
    object.add("cuts", summary.wasted.cuts);
    object.add("cuts_moved_too_far", summary.wasted.moved_too_far);
    object.add("retries", summary.wasted.retries);
    object.add("iterations", summary.iterations);
    object.add("unconverged_iterations", summary.wasted.iterations);
    object.add("contact_search", contact_search(summary));
    object.add("energy_residual", summary.energy_residual);
    object.add("energy_J_per_m", numbers(summary.energy, 1));
    object.add("joints", joints(summary));
    object.add("slip_m", slip(summary));
    object.add("filter_frequency_hz", summary.filter_frequency);
    object.add("outcrop_peak_acceleration_m_s2", summary.outcrop_peak_acceleration);
    object.add("monitors", monitors);
    object.add("timings_s", numbers(summary.timings, 1));
    return object.text() + "\n";
  }



  void write_summary(const Summary &summary, const std::string &file_name)
  {
    write_atomically(file_name, to_json(summary));
  }
} // namespace hybrid::output
