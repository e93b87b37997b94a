// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/mesh/joint_lines.h>
#include <hybrid/scene/mesh/polygon_reader.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    struct Vertex
    {
      int         line;  ///< in the file
      Vec2        x;     ///< [m]
      std::string joint; ///< line of the edge that begins here, or empty
    };

    struct Polygon
    {
      std::string         name;
      std::string         region;
      std::vector<Vertex> vertices;
    };


    /// Of a row: "sliding_mass" where it names none.
    std::string region_of(const TableRow &row, const std::string &file)
    {
      const std::string region =
        row.fields.size() > 3 && !row.fields[3].empty() ? row.fields[3] : "sliding_mass";
      if (region != "sliding_mass" && (region.rfind("sliding_mass_", 0) != 0 || region.size() < 14))
        throw InputError(file,
                         row.line,
                         "the region '" + region +
                           "' is not allowed; it must be sliding_mass or sliding_mass_<suffix>.");
      return region;
    }


    /// Line of the edge that begins at a row's vertex; empty: none.
    std::string joint_of(const TableRow &row, const std::string &file)
    {
      const std::string joint = row.fields.size() > 4 ? row.fields[4] : "";
      if (!joint.empty() && !is_joint_line(joint))
        throw InputError(file,
                         row.line,
                         "the joint '" + joint + "' is not allowed; it must be joint_<suffix>.");
      return joint;
    }


    std::vector<Polygon> collect_polygons(const std::string &file)
    {
      check_heading(file, {"block", "x", "y", "region", "joint"});
      const std::vector<TableRow> rows = read_text_table(file);

      std::vector<Polygon>  polygons;
      std::set<std::string> names;
      for (const TableRow &row : rows)
        {
          if (row.fields.size() < 3 || row.fields.size() > 5)
            throw wrong_columns(row, "block, x, y and optionally region, joint", file);
          const std::string  region = region_of(row, file);
          const std::string &name   = row.fields[0];
          if (polygons.empty() || polygons.back().name != name)
            {
              if (!names.insert(name).second)
                throw InputError(file,
                                 row.line,
                                 "the rows of block " + name + " do not follow each other.");
              polygons.push_back({name, region, {}});
            }
          if (polygons.back().region != region)
            throw InputError(file,
                             row.line,
                             "block " + name + " is in two regions, " + polygons.back().region +
                               " and " + region + ".");
          polygons.back().vertices.push_back(
            {row.line,
             Vec2(to_number(row.fields[1], "x [m]", file, row.line),
                  to_number(row.fields[2], "y [m]", file, row.line)),
             joint_of(row, file)});
        }
      if (polygons.empty())
        throw InputError(file, 0, "the file has no block.");
      return polygons;
    }


    /// Position of c relative to the directed line a-b: 1 left, -1 right, 0 on it (to round-off).
    int side(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
      const double value     = cross(b - a, c - a);
      const double tolerance = 1e-12 * ((b - a).squaredNorm() + (c - a).squaredNorm());
      return value > tolerance ? 1 : (value < -tolerance ? -1 : 0);
    }


    /// @return whether the closed segments a-b and c-d have a point in common.
    bool segments_meet(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
    {
      const auto within = [](const Vec2 &p, const Vec2 &q, const Vec2 &r) {
        return (r - p).dot(r - q) <= 0.;
      };
      const int c_side = side(a, b, c), d_side = side(a, b, d);
      const int a_side = side(c, d, a), b_side = side(c, d, b);
      if (c_side * d_side < 0 && a_side * b_side < 0)
        return true;
      return (c_side == 0 && within(a, b, c)) || (d_side == 0 && within(a, b, d)) ||
             (a_side == 0 && within(c, d, a)) || (b_side == 0 && within(c, d, b));
    }


    std::string at(const Vec2 &x)
    {
      std::ostringstream text;
      text << " at (" << x.x() << ", " << x.y() << ") m";
      return text.str();
    }


    void check_simple(const Polygon &polygon, const std::string &file)
    {
      const auto       &v = polygon.vertices;
      const std::size_t n = v.size();
      if (n < 3)
        throw InputError(file,
                         v.front().line,
                         "block " + polygon.name + " has " + std::to_string(n) +
                           (n == 1 ? " vertex" : " vertices") + at(v.front().x) +
                           "; at least three are needed.");
      for (std::size_t i = 0; i < n; ++i)
        {
          const Vertex &a = v[i], &b = v[(i + 1) % n], &c = v[(i + 2) % n];
          if (a.x == b.x)
            throw InputError(file,
                             b.line,
                             "block " + polygon.name + " repeats the vertex of line " +
                               std::to_string(a.line) + at(b.x) + ".");
          if (side(a.x, b.x, c.x) == 0 && (b.x - a.x).dot(c.x - b.x) < 0.)
            throw InputError(file,
                             b.line,
                             "block " + polygon.name + " folds back on itself (zero area)" +
                               at(b.x) + ".");
        }
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j)
          if ((j + 1) % n != i && segments_meet(v[i].x, v[i + 1].x, v[j].x, v[(j + 1) % n].x))
            throw InputError(file,
                             v[i].line,
                             "block " + polygon.name +
                               " is not a simple polygon: the edges that start in line " +
                               std::to_string(v[i].line) + at(v[i].x) + " and in line " +
                               std::to_string(v[j].line) + at(v[j].x) +
                               " meet (rows of two blocks that have one name are one block).");
    }


    double signed_area(const Polygon &polygon)
    {
      const auto &v    = polygon.vertices;
      double      area = 0.;
      for (std::size_t i = 1; i + 1 < v.size(); ++i)
        area += 0.5 * cross(v[i].x - v[0].x, v[i + 1].x - v[0].x);
      return area;
    }


    /// Length of the shortest edge [m].
    double shortest_edge(const Polygon &polygon)
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < polygon.vertices.size(); ++i)
        {
          const Vec2 &a = polygon.vertices[i].x;
          const Vec2 &b = polygon.vertices[(i + 1) % polygon.vertices.size()].x;
          if (a != b)
            shortest = std::min(shortest, (b - a).norm());
        }
      return shortest;
    }


    /// Nodes by their coordinates: what is within a distance of a node is that node, as the last
    /// digits of a file may be rounded.
    class NodeFinder
    {
    public:
      explicit NodeFinder(std::vector<Vec2> &node_list)
        : nodes(node_list)
      {}

      /// @param distance within which places are the same for the polygon of this corner [m]
      int find_or_add(const Vec2 &x, const double distance)
      {
        for (auto near = index.lower_bound(x.x() - distance);
             near != index.end() && near->first <= x.x() + distance;
             ++near)
          if ((nodes[near->second] - x).norm() <= std::min(distance, distances.at(near->second)))
            return near->second;
        const int number = static_cast<int>(nodes.size());
        index.emplace(x.x(), number);
        distances.emplace(number, distance);
        nodes.push_back(x);
        return number;
      }

    private:
      std::vector<Vec2>         &nodes;
      std::multimap<double, int> index;     ///< by x
      std::map<int, double>      distances; ///< of the polygon that a node is from [m]
    };


    /// Drop nodes that only the replaced blocks used.
    void drop_unused_nodes(SectionMesh &mesh)
    {
      std::vector<int> number(mesh.nodes.size(), -1);
      for (const auto &cell : mesh.bedrock_cells)
        for (const int node : cell)
          number[node] = 0;
      for (const auto &[name, edges] : mesh.lines)
        for (const auto &edge : edges)
          number[edge[0]] = number[edge[1]] = 0;

      std::vector<Vec2> kept;
      for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] == 0)
          {
            number[i] = kept.size();
            kept.push_back(mesh.nodes[i]);
          }
      mesh.nodes = kept;
      for (auto &cell : mesh.bedrock_cells)
        for (int &node : cell)
          node = number[node];
      for (auto &[name, edges] : mesh.lines)
        for (auto &edge : edges)
          edge = {number[edge[0]], number[edge[1]]};
    }


    /// A surface that runs up and down the same vertical line.
    void check_fold(const Vec2        &before,
                    const Vec2        &x,
                    const Vec2        &after,
                    const std::string &file,
                    const int          line)
    {
      if (side(before, x, after) == 0 && (x - before).dot(after - x) < 0.)
        throw InputError(file, line, "the surface folds back on itself" + at(x) + ".");
    }
  } // namespace


  void read_polygons(const std::string &file, SectionMesh &mesh)
  {
    const std::vector<Polygon> polygons = collect_polygons(file);

    mesh.blocks.clear();
    mesh.block_region.clear();
    mesh.block_region_names.clear();
    for (auto line = mesh.lines.begin(); line != mesh.lines.end();)
      if (line->first == "mass_surface" || is_joint_line(line->first))
        line = mesh.lines.erase(line);
      else
        ++line;
    drop_unused_nodes(mesh);

    constexpr double same_place = 1e-6; ///< of the shortest edge [-]
    NodeFinder       finder(mesh.nodes);
    std::set<std::pair<std::string, std::pair<int, int>>>
      joints; ///< both blocks may name an edge's
    for (const Polygon &polygon : polygons)
      {
        check_simple(polygon, file);
        const double     distance = same_place * shortest_edge(polygon);
        std::vector<int> block;
        for (const Vertex &vertex : polygon.vertices)
          block.push_back(finder.find_or_add(vertex.x, distance));
        if (signed_area(polygon) < 0.)
          throw InputError(file,
                           polygon.vertices.front().line,
                           "block " + polygon.name + " runs clockwise from its first vertex" +
                             at(polygon.vertices.front().x) +
                             "; vertices must be listed counter-clockwise.");
        for (std::size_t k = 0; k < block.size(); ++k)
          {
            const std::string &joint = polygon.vertices[k].joint;
            const int          a = block[k], b = block[(k + 1) % block.size()];
            if (!joint.empty() && joints.insert({joint, std::minmax(a, b)}).second)
              mesh.lines[joint].push_back({a, b});
          }
        mesh.blocks.push_back(block);
        mesh.block_names.push_back(polygon.name);

        auto      &names = mesh.block_region_names;
        const auto found = std::find(names.begin(), names.end(), polygon.region);
        mesh.block_region.push_back(found - names.begin());
        if (found == names.end())
          names.push_back(polygon.region);
      }
  }


  void read_surface(const std::string &file, SectionMesh &mesh)
  {
    check_heading(file, {"x", "y"});
    const std::vector<TableRow> rows = read_text_table(file);
    if (rows.size() < 2)
      throw InputError(file,
                       0,
                       "found " + std::to_string(rows.size()) +
                         (rows.size() == 1 ? " point" : " points") +
                         "; a surface needs at least two.");

    auto &edges = mesh.lines["sliding_surface"];
    edges.clear();
    const int first_node = mesh.nodes.size();
    for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const TableRow &row = rows[i];
        if (row.fields.size() != 2)
          throw wrong_columns(row, "x, y", file);
        const Vec2 x(to_number(row.fields[0], "x [m]", file, row.line),
                     to_number(row.fields[1], "y [m]", file, row.line));
        if (i > 0)
          {
            if (x.x() < mesh.nodes.back().x())
              throw InputError(file,
                               row.line,
                               "x = " + row.fields[0] +
                                 " is left of the point before; the "
                                 "surface must run from left to right.");
            if (x == mesh.nodes.back())
              throw InputError(file, row.line, "the point is the same as the one before.");
            if (i > 1)
              check_fold(mesh.nodes[mesh.nodes.size() - 2], mesh.nodes.back(), x, file, row.line);
            edges.push_back({first_node + int(i) - 1, first_node + int(i)});
          }
        mesh.nodes.push_back(x);
      }
  }
} // namespace hybrid::scene
