// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/crash_guard.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/corner_cells.h>
#include <hybrid/scene/mesh/curve_check.h>
#include <hybrid/scene/mesh/edge_chain.h>
#include <hybrid/scene/mesh/joint_lines.h>
#include <hybrid/scene/mesh/mesh_file_check.h>
#include <hybrid/scene/mesh/mesh_number.h>
#include <hybrid/scene/mesh/mesh_size_limit.h>
#include <hybrid/scene/mesh/polygon_reader.h>
#include <hybrid/scene/mesh/section_mesh_reader.h>
#include <hybrid/scene/mesh/unit_check.h>
#include <hybrid/scene/reading_limit.h>
#include <hybrid/scene/text_table.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    using Numbers = std::vector<std::pair<std::string, double>>;

    const char *const allowed_groups =
      "surfaces bedrock, bedrock_<suffix>, sliding_mass, sliding_mass_<suffix>; "
      "curves sliding_surface, bedding_<n>, joint_<suffix>, base, left, right, ground, mass_surface";


    /// gmsh, started for one file: quiet, on one thread, without configuration files.
    class GmshSession
    {
    public:
      GmshSession()
      {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
        gmsh::option::setNumber("General.ExpertMode", 1); // asks no questions on standard input
        gmsh::onelab::clear();                            // numbers outlive gmsh::finalize()
        gmsh::logger::start();
      }

      ~GmshSession()
      {
        gmsh::finalize();
      }

      GmshSession(const GmshSession &)            = delete;
      GmshSession &operator=(const GmshSession &) = delete;

      /// Run @p action; whatever gmsh objects to becomes an InputError about @p file.
      template <typename Action>
      void run(const std::string &file, const Action &action)
      {
        try
          {
            action();
          }
        catch (const InputError &)
          {
            throw;
          }
        catch (const std::string &message)
          {
            throw complaint(file, message);
          }
        catch (const std::bad_alloc &)
          {
            throw InputError(file, 0, ReadingLimit::memory_sentence());
          }
        catch (const std::exception &exception)
          {
            throw complaint(file, exception.what());
          }
        catch (...)
          {
            throw complaint(file, last_error());
          }
        const std::string message = last_error();
        if (!message.empty())
          throw complaint(file, message);
      }

    private:
      static std::string last_error()
      {
        std::string message;
        gmsh::logger::getLastError(message);
        return message;
      }

      /// gmsh's sentence; where it is "'file', line 7: text" with the line in its place.
      static InputError complaint(const std::string &file, const std::string &message)
      {
        if (message.rfind("Out of memory", 0) == 0)
          return InputError(file, 0, ReadingLimit::memory_sentence());
        const std::string own = "'" + file + "', line ";
        if (message.rfind(own, 0) != 0)
          return InputError(file, 0, "gmsh: " + message + ".");
        const std::size_t end  = message.find(": ", own.size());
        const int         line = std::atoi(message.c_str() + own.size());
        return InputError(file,
                          line,
                          "gmsh: " +
                            (end == std::string::npos ? message : message.substr(end + 2)) + ".");
      }
    };


    /// Refuse numbers that the geometry does not define, or outside the range it states.
    void check_numbers(const std::string &file, const Numbers &numbers)
    {
      const CrashGuard         guard(file);
      GmshSession              session;
      std::vector<std::string> names;
      session.run(file, [&]() {
        const ReadingLimit limit(file);
        gmsh::open(file);
        gmsh::onelab::getNames(names);
      });

      std::string known;
      for (const std::string &name : names)
        if (name.rfind("Gmsh/", 0) != 0 && name.rfind("ONELAB/", 0) != 0)
          known += (known.empty() ? "" : ", ") + name;

      for (const auto &[name, value] : numbers)
        {
          if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError(file,
                             0,
                             "there is no number '" + name + "'; the file defines " +
                               (known.empty() ? "none" : known) + ".");
          std::string json;
          gmsh::onelab::get(json, name);
          if (const std::string wrong = outside_range(json, value); !wrong.empty())
            throw InputError(file, 0, "the number '" + name + "' is " + wrong + ".");
        }
    }


    bool is_region(const std::string &name, const std::string &stem)
    {
      return name == stem || (name.rfind(stem + "_", 0) == 0 && name.size() > stem.size() + 1);
    }


    bool is_line(const std::string &name)
    {
      for (const char *const line :
           {"sliding_surface", "base", "left", "right", "ground", "mass_surface"})
        if (name == line)
          return true;
      return is_joint_line(name) || (name.rfind("bedding_", 0) == 0 && name.size() > 8 &&
                                     name.find_first_not_of("0123456789", 8) == std::string::npos);
    }


    InputError
    outside_plane(const std::string &file, const std::string &what, const std::vector<double> &x)
    {
      std::ostringstream sentence;
      sentence << "the " << what << " at (" << x[0] << ", " << x[1] << ", " << x[2]
               << ") m is outside the plane z = 0 of the section.";
      return InputError(file, 0, sentence.str());
    }


    /// Copies gmsh's current mesh into a SectionMesh.
    class Converter
    {
    public:
      explicit Converter(const std::string &file_name)
        : file(file_name)
      {}

      SectionMesh convert()
      {
        read_nodes();
        gmsh::vectorpair groups;
        gmsh::model::getPhysicalGroups(groups);
        for (const auto &[dim, tag] : groups)
          read_group(dim, tag);
        number_used_nodes();
        for (auto &[name, edges] : mesh.lines)
          if (!is_joint_line(name))
            edges = chain_edges(edges, mesh.nodes, name);
        return std::move(mesh);
      }

    private:
      const std::string file;
      SectionMesh       mesh;

      std::map<std::size_t, int>
        index_of_tag; ///< gmsh's node tag -> index into coordinates, in the order of tags
      std::vector<Vec2>                  coordinates; ///< all nodes of gmsh's mesh [m]
      std::map<std::size_t, std::string> group_of_element;


      void read_nodes()
      {
        std::vector<std::size_t> tags;
        std::vector<double>      x, parametric;
        gmsh::model::mesh::getNodes(tags, x, parametric);
        std::map<std::size_t, std::size_t> position;
        for (std::size_t i = 0; i < tags.size(); ++i)
          position[tags[i]] = i;

        double size = 0.;
        for (const double value : x)
          size = std::max(size, std::abs(value));
        for (const auto &[tag, i] : position)
          {
            for (int axis = 0; axis < 3; ++axis)
              if (!std::isfinite(x[3 * i + axis]))
                throw InputError(file,
                                 0,
                                 "the coordinate " + std::string(1, "xyz"[axis]) + " of node " +
                                   std::to_string(tag) + " is not a finite number.");
            if (std::abs(x[3 * i + 2]) > 1e-9 * size)
              throw outside_plane(file, "node", {x[3 * i], x[3 * i + 1], x[3 * i + 2]});
            index_of_tag[tag] = coordinates.size();
            coordinates.emplace_back(x[3 * i], x[3 * i + 1]);
          }
      }


      void read_group(const int dim, const int tag)
      {
        std::string name;
        gmsh::model::getPhysicalName(dim, tag, name);
        const bool is_bedrock = dim == 2 && is_region(name, "bedrock");
        const bool is_mass    = dim == 2 && is_region(name, "sliding_mass");
        if (!is_bedrock && !is_mass && !(dim == 1 && is_line(name)))
          throw InputError(file,
                           0,
                           "the physical group " +
                             (name.empty() ? std::to_string(tag) : "'" + name + "'") +
                             " of dimension " + std::to_string(dim) +
                             " is not known; allowed are " + allowed_groups + ".");
        if (is_bedrock)
          mesh.bedrock_region_names.push_back(name);
        else if (is_mass)
          mesh.block_region_names.push_back(name);

        std::vector<int> entities;
        gmsh::model::getEntitiesForPhysicalGroup(dim, tag, entities);
        for (const int entity : entities)
          {
            std::vector<int>                      types;
            std::vector<std::vector<std::size_t>> elements, element_nodes;
            gmsh::model::mesh::getElements(types, elements, element_nodes, dim, entity);
            for (std::size_t t = 0; t < types.size(); ++t)
              read_elements(name, types[t], elements[t], element_nodes[t]);
            mesh.bedrock_surface.resize(mesh.bedrock_cells.size(), entity);
          }
      }


      void read_elements(const std::string              &name,
                         const int                       type,
                         const std::vector<std::size_t> &elements,
                         const std::vector<std::size_t> &tags)
      {
        // gmsh's element types: 1 two-node line, 2 triangle, 3 quadrangle
        if (type < 1 || type > 3)
          throw InputError(file,
                           0,
                           "the group " + name + " has elements of gmsh's type " +
                             std::to_string(type) +
                             "; only first-order lines, triangles and quadrangles are allowed.");
        const int n = type + 1;
        for (std::size_t e = 0; e < elements.size(); ++e)
          {
            std::vector<int> nodes(n);
            for (int i = 0; i < n; ++i)
              nodes[i] = index_of_tag.at(tags[e * n + i]);
            const auto [group, is_new] = group_of_element.emplace(elements[e], name);
            if (!is_new)
              throw InputError(file,
                               0,
                               "the element " + at(nodes) + " is in two physical groups, " +
                                 group->second + " and " + name + ".");
            add_element(name, nodes);
          }
      }


      void add_element(const std::string &name, std::vector<int> nodes)
      {
        if (nodes.size() == 2)
          {
            mesh.lines[name].push_back({nodes[0], nodes[1]});
            return;
          }

        double area = 0.;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          area += cross(coordinates[nodes[i]] - coordinates[nodes[0]],
                        coordinates[nodes[(i + 1) % nodes.size()]] - coordinates[nodes[0]]);
        if (area < 0.)
          std::reverse(nodes.begin() + 1, nodes.end());

        if (!is_region(name, "bedrock"))
          {
            mesh.blocks.push_back(nodes);
            mesh.block_region.push_back(mesh.block_region_names.size() - 1);
            return;
          }
        if (nodes.size() != 4)
          throw InputError(file,
                           0,
                           "the group " + name + " has a triangle " + at(nodes) +
                             "; the bedrock must be quadrilaterals only (Recombine Surface, "
                             "Mesh.RecombinationAlgorithm = 3).");
        mesh.bedrock_cells.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
        mesh.bedrock_region.push_back(mesh.bedrock_region_names.size() - 1);
      }


      /// "at (x, y) m", the centre of some nodes.
      std::string at(const std::vector<int> &nodes) const
      {
        Vec2 centre = Vec2::Zero();
        for (const int node : nodes)
          centre += coordinates[node] / double(nodes.size());
        std::ostringstream text;
        text << "at (" << centre.x() << ", " << centre.y() << ") m";
        return text.str();
      }


      template <typename Function>
      void for_each_node(const Function &function)
      {
        for (auto &cell : mesh.bedrock_cells)
          std::for_each(cell.begin(), cell.end(), function);
        for (auto &block : mesh.blocks)
          std::for_each(block.begin(), block.end(), function);
        for (auto &[name, edges] : mesh.lines)
          for (auto &edge : edges)
            std::for_each(edge.begin(), edge.end(), function);
      }


      void number_used_nodes()
      {
        std::vector<int> number(coordinates.size(), -1);
        for_each_node([&](const int &node) { number[node] = 0; });
        for (std::size_t i = 0; i < coordinates.size(); ++i)
          if (number[i] == 0)
            {
              number[i] = mesh.nodes.size();
              mesh.nodes.push_back(coordinates[i]);
            }
        for_each_node([&](int &node) { node = number[node]; });
      }
    };


    /// Before gmsh fills a section of a million kilometres with cells of metres.
    void check_corners(const std::string &file)
    {
      gmsh::vectorpair points;
      gmsh::model::getEntities(points, 0);
      if (points.empty())
        return;
      Vec2                low(1e300, 1e300), high(-1e300, -1e300);
      std::vector<double> farthest{0., 0., 0.}; // from the plane of the section
      for (const auto &[dim, tag] : points)
        {
          std::vector<double> x;
          gmsh::model::getValue(dim, tag, {}, x);
          for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(x[axis]))
              throw InputError(file,
                               0,
                               "the coordinate " + std::string(1, "xyz"[axis]) + " of point " +
                                 std::to_string(tag) + " is not a finite number.");
          if (std::abs(x[2]) > std::abs(farthest[2]))
            farthest = x;
          low  = low.cwiseMin(Vec2(x[0], x[1]));
          high = high.cwiseMax(Vec2(x[0], x[1]));
        }
      check_extent(low, high);
      if (std::abs(farthest[2]) > 1e-9 * (high - low).maxCoeff())
        throw outside_plane(file, "point", farthest);
    }


    /// Once the curves of a geometry are meshed. @return the number of cells at most.
    double check_before_meshing(const std::string &file, CrashGuard &guard)
    {
      constexpr double frontal_for_quads = 8.;
      check_curves(file);
      double algorithm = 0.;
      gmsh::option::getNumber("Mesh.Algorithm", algorithm);
      if (algorithm == frontal_for_quads)
        guard.suspect("it sets Mesh.Algorithm = 8, with which gmsh 4.8 crashes on many sections: "
                      "set 6, the frontal Delaunay method");
      const std::string within = curves_within_surfaces();
      if (!within.empty())
        guard.suspect("look at " + within +
                      ": divide a recombined surface along each curve, a Plane Surface on either "
                      "side, as gmsh keeps no curve within it");
      return check_mesh_size(file);
    }


    /// Those that the file defines, as they were meshed with.
    std::map<std::string, double> resolutions()
    {
      std::map<std::string, double> found;
      std::vector<std::string>      names;
      gmsh::onelab::getNames(names);
      for (const std::string &name : names)
        if (std::vector<double> value; name.rfind("Resolution/", 0) == 0)
          {
            gmsh::onelab::getNumber(name, value);
            if (!value.empty())
              found[name] = value.front();
          }
      return found;
    }


    SectionMesh read_gmsh_file(const std::string                 &file,
                               const Numbers                     &numbers,
                               const std::function<void(double)> &before_meshing)
    {
      check_mesh_file(file);
      const std::string extension = std::filesystem::path(file).extension().string();
      if (extension == ".msh" && !numbers.empty())
        throw InputError(file,
                         0,
                         "the number '" + numbers.front().first +
                           "' cannot be set: only a .geo file has numbers.");

      if (!numbers.empty())
        check_numbers(file, numbers);

      CrashGuard  guard(file);
      GmshSession session;
      session.run(file, [&]() {
        for (const auto &[name, value] : numbers)
          gmsh::onelab::setNumber(name, {value});
        if (extension == ".msh")
          {
            gmsh::open(file);
            return;
          }
        {
          const ReadingLimit limit(file);
          gmsh::open(file);
          check_corners(file);
          gmsh::model::mesh::generate(1);
        }
        const double cells = check_before_meshing(file, guard);
        if (before_meshing)
          before_meshing(cells);
        gmsh::model::mesh::generate(2);
      });
      SectionMesh mesh;
      session.run(file, [&]() { mesh = Converter(file).convert(); });
      if (extension == ".geo")
        session.run(file, [&]() { mesh.resolutions = resolutions(); });
      return mesh;
    }
  } // namespace


  SectionMesh read_section_mesh(const MeshParameters              &parameters,
                                const std::function<void(double)> &before_meshing)
  {
    SectionMesh mesh;
    if (!parameters.file.empty())
      mesh = read_gmsh_file(parameters.file, parameters.numbers, before_meshing);
    if (!parameters.polygons_file.empty())
      read_polygons(parameters.polygons_file, mesh);
    if (!parameters.surface_file.empty())
      read_surface(parameters.surface_file, mesh);
    halve_corner_cells(mesh, parameters.corner_levels);
    return mesh;
  }
} // namespace hybrid::scene
