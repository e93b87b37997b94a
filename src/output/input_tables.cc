// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/input_tables.h>

namespace hybrid::output
{
  void write_spectrum(HistoryFile &file, const scene::SpectrumFit &fit, const bool outcrop)
  {
    const std::size_t n = fit.frequency.size();
    if (n == 0)
      return;
    file.write_table("spectrum/frequency", "Hz", fit.frequency.data(), n, 1, "of oscillators");
    file.write_table(
      "spectrum/target", "m/s2", fit.target.data(), n, 1, "pseudo-acceleration asked for");
    file.write_table(
      "spectrum/reached", "m/s2", fit.reached.data(), n, 1, "of the motion as given");
    file.set_attribute("spectrum", "damping", std::vector<double>{fit.damping});
    file.set_attribute("spectrum", "outcrop", outcrop ? "yes" : "no");
  }



  void write_heterogeneity(HistoryFile                          &file,
                           const scene::HeterogeneityParameters &heterogeneity,
                           const dda::Model                     &model)
  {
    const std::string group = "heterogeneity";
    if (heterogeneity.modulus_shape > 0.)
      {
        std::vector<double> factor;
        for (const dda::BlockProperties &block : model.blocks)
          factor.push_back(block.modulus_factor);
        file.write_table(group + "/modulus_factor",
                         "1",
                         factor.data(),
                         factor.size(),
                         1,
                         "on the Young modulus of each block");
        file.set_attribute(group,
                           "modulus_shape",
                           std::vector<double>{heterogeneity.modulus_shape});
      }
    if (heterogeneity.strength_shape > 0. && !model.joints.empty())
      {
        std::vector<double> factor, ends;
        for (const dda::Joint &joint : model.joints)
          {
            factor.push_back(joint.strength_factor);
            for (const dda::Joint::Point &point : joint.points)
              {
                const Vec2 x = joint_point(model.initial, joint, point);
                ends.insert(ends.end(), {x.x(), x.y()});
              }
          }
        file.write_table(group + "/strength_factor",
                         "1",
                         factor.data(),
                         factor.size(),
                         1,
                         "on cohesion and tensile strength of each joint");
        file.write_table(group + "/joint_ends", "m", ends.data(), factor.size(), 4, "initial");
        file.set_attribute(group,
                           "strength_shape",
                           std::vector<double>{heterogeneity.strength_shape});
      }
  }



  void write_water(HistoryFile &file, const dda::Model &model)
  {
    if (model.water.action != dda::Water::Action::pressures || model.n_foundation_nodes() == 0)
      return;
    const Eigen::VectorXd force = dda::water_on_surface(model.water,
                                                        model.initial.foundation_nodes,
                                                        model.initial.foundation_degree);
    file.write_table("interface/water_force",
                     "N/m",
                     force.data(),
                     model.initial.foundation_nodes.size(),
                     2,
                     "of the water on each node, to be added for the total");
  }



  void write_water_tables(HistoryFile &file, const scene::WaterTables &tables)
  {
    const auto write = [&](const std::string        &name,
                           const std::string        &unit,
                           const scene::LinearTable &table,
                           const std::string        &meaning) {
      std::vector<double> rows;
      for (const Vec2 &point : table.points)
        rows.insert(rows.end(), {point.x(), point.y()});
      if (!table.empty())
        file.write_table("section/" + name, unit, rows.data(), table.points.size(), 2, meaning);
    };
    write("water_line", "m", tables.line, "phreatic line");
    write("water_levels", "s, m", tables.level, "time and level of the water");
  }



  Vec2
  joint_point(const dda::Geometry &initial, const dda::Joint &joint, const dda::Joint::Point &point)
  {
    const Vec2 &a = initial.vertices[joint.edge], &b = initial.vertices[initial.next(joint.edge)];
    return a + point.position * (b - a);
  }
} // namespace hybrid::output
