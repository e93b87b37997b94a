// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/checks/free_field_check.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    // All in column heights [-].
    constexpr double strip           = 0.25; ///< width of the ground beside the side
    constexpr double difference_at   = 1e-3; ///< of ground and column that counts at the side
    constexpr double difference_near = 0.05; ///< and within the strip
    constexpr int    samples         = 32;   ///< across the strip

    struct Column
    {
      double x, bottom, top; ///< [m]

      double height() const
      {
        return top - bottom;
      }
    };


    Column column_of(const SectionMesh &mesh, const std::string &side)
    {
      Column column{0., 1e300, -1e300};
      for (const auto &edge : mesh.lines.at(side))
        for (const int node : edge)
          {
            column.x      = mesh.nodes[node].x();
            column.bottom = std::min(column.bottom, mesh.nodes[node].y());
            column.top    = std::max(column.top, mesh.nodes[node].y());
          }
      return column;
    }


    /// Elevation of the ground, blocks included, at ascending places along x.
    class Ground
    {
    public:
      explicit Ground(std::vector<double> places)
        : x(std::move(places))
        , y(x.size(), -1e300)
      {}

      /// An edge from a to b.
      void raise(const Vec2 &a, const Vec2 &b)
      {
        const Vec2 &left = a.x() < b.x() ? a : b, &right = a.x() < b.x() ? b : a;
        for (auto k = std::lower_bound(x.begin(), x.end(), left.x()) - x.begin();
             k < static_cast<long>(x.size()) && x[k] <= right.x();
             ++k)
          {
            const double t =
              right.x() > left.x() ? (x[k] - left.x()) / (right.x() - left.x()) : 0.5;
            y[k] = std::max(y[k], left.y() + t * (right.y() - left.y()));
          }
      }

      std::vector<double> x; ///< [m]
      std::vector<double> y; ///< [m]
    };


    Ground ground_beside(const SectionMesh     &mesh,
                         const SceneParameters &scene,
                         const Column          &column,
                         const bool             is_left)
    {
      Vec2 low = mesh.nodes[0], high = low;
      for (const Vec2 &node : mesh.nodes)
        {
          low  = low.cwiseMin(node);
          high = high.cwiseMax(node);
        }
      const double        width = std::min(strip * column.height(), 0.5 * (high.x() - low.x()));
      std::vector<double> places;
      for (int k = 0; k <= samples; ++k) // the first beside the corner, as corners are rounded
        places.push_back(column.x +
                         (is_left ? 1. : -1.) * width * std::max(double(k), 1e-6) / samples);
      std::sort(places.begin(), places.end());
      Ground     ground(places);
      const auto add = [&](const auto &outline) {
        for (std::size_t i = 0; i < outline.size(); ++i)
          ground.raise(mesh.nodes[outline[i]], mesh.nodes[outline[(i + 1) % outline.size()]]);
      };
      for (const auto &cell : mesh.bedrock_cells)
        add(cell);
      if (scene.blocks.enabled)
        for (const auto &block : mesh.blocks)
          add(block);
      return ground;
    }


    /// The largest difference that counts, as a sentence; empty if there is none.
    std::string
    warning_of(const SectionMesh &mesh, const SceneParameters &scene, const std::string &side)
    {
      const Column column  = column_of(mesh, side);
      const bool   left    = side == "left";
      const Ground ground  = ground_beside(mesh, scene, column, left);
      double       largest = 0., where = 0.;
      for (int i = 0; i <= samples; ++i) // from the side inwards
        {
          const int    k          = left ? i : samples - i;
          const double difference = ground.y[k] - column.top;
          const double allowed    = (i == 0 ? difference_at : difference_near) * column.height();
          if (ground.y[k] > -1e299 && std::abs(difference) > allowed &&
              std::abs(difference) > std::abs(largest) + 1e-9 * column.height())
            {
              largest = difference;
              where   = i == 0 ? column.x : ground.x[k];
            }
        }
      if (largest == 0.)
        return "";
      std::ostringstream text;
      text.precision(4);
      text << "the ground beside the line " << side << " is up to " << std::abs(largest) << " m "
           << (largest > 0. ? "higher" : "lower") << " (at x = " << where
           << " m) than the free-field column there, which is " << column.height()
           << " m high and ends at y = " << column.top
           << " m, so that it sends in the motion of other ground; let bedrock reach the ground at "
              "the side and keep it level for "
           << strip * column.height() << " m, or set Continuum/Sides = viscous";
      return text.str();
    }



    /// Sides that only absorb take the motion of level ground away, too.
    std::string warning_of_dashpots(const SectionMesh &mesh)
    {
      constexpr double far  = 10.; ///< from the middle to the sides, in heights of the sides
      const Column     left = column_of(mesh, "left"), right = column_of(mesh, "right");
      const double     height = std::max(left.height(), right.height());
      const double     width  = right.x - left.x;
      if (width >= 2. * far * height)
        return "";
      std::ostringstream text;
      text.precision(4);
      text
        << "Continuum/Sides = viscous: dashpots alone do not bring the motion in and take that of "
           "the ground away, here "
        << width << " m wide and " << height
        << " m high, so that it is shaken too little; set it to free field, or let the sides be "
        << far * height << " m from the middle";
      return text.str();
    }
    /// Sides that hold the ground along the motion that comes in.
    std::string warning_of_held_sides(const SceneParameters &scene)
    {
      const SideBoundary &sides = scene.continuum.sides;
      const double        angle = scene.motion.angle * M_PI / 180.;
      const bool          x     = std::abs(std::cos(angle)) > 1e-6,
                 y = std::abs(std::sin(angle)) > 1e-6 || !scene.motion.vertical_file.empty();
      if (!(sides.holds_x && x) && !(sides.holds_y && y))
        return "";
      return "Continuum/Sides = " + sides.name + " holds the sides, along which the motion comes " +
             "in: they stay where they are, and the ground between them hardly moves; set it to "
             "free field";
    }


    /// A plane that ends on a side.
    struct PlaneEnd
    {
      std::string name;
      int         node;
      double      inclination; ///< of its last edge [deg]
    };


    std::vector<PlaneEnd> ends_on_sides(const SectionMesh &mesh, const SceneParameters &scene)
    {
      std::vector<PlaneEnd> ends;
      for (const char *const side : {"left", "right"})
        {
          const Column column  = column_of(mesh, side);
          const auto   is_here = [&](const int node) {
            return std::abs(mesh.nodes[node].x() - column.x) <= 1e-9 * column.height();
          };
          const auto parts_column = [&](const int node) { // in a corner it has no rock on one side
            const auto &edges = mesh.lines.at(side);
            return std::count_if(edges.begin(), edges.end(), [&](const auto &edge) {
                     return edge[0] == node || edge[1] == node;
                   }) == 2;
          };
          for (const std::string &name : scene.bedding.names)
            if (const auto plane = mesh.lines.find(name); plane != mesh.lines.end())
              for (const auto &[a, b] : plane->second)
                if (is_here(a) != is_here(b) && parts_column(is_here(a) ? a : b))
                  {
                    const Vec2 along = mesh.nodes[a] - mesh.nodes[b];
                    ends.push_back(
                      {name,
                       is_here(a) ? a : b,
                       std::atan2(std::abs(along.y()), std::abs(along.x())) * 180. / M_PI});
                  }
        }
      return ends;
    }


    bool meets_another(const PlaneEnd &end, const std::vector<PlaneEnd> &ends)
    {
      return std::count_if(ends.begin(), ends.end(), [&](const PlaneEnd &other) {
               return other.node == end.node;
             }) > 1;
    }


    /// Planes that may slip or give way where they meet a side whose column does not.
    std::string warning_of_held_planes(const SceneParameters       &scene,
                                       const std::vector<PlaneEnd> &ends)
    {
      const bool               has_joints = scene.continuum.sides.has_free_field;
      std::vector<std::string> held;
      for (const PlaneEnd &end : ends)
        if ((!has_joints || meets_another(end, ends)) &&
            std::find(held.begin(), held.end(), end.name) == held.end())
          held.push_back(end.name);
      if (held.empty())
        return "";
      std::string names = held.front();
      for (std::size_t k = 1; k < held.size(); ++k)
        names += ", " + held[k];
      names += has_joints
                 ? ": where planes meet each other at a side they are held back, as the free-field "
                   "column has no joint there"
                 : ": where a plane reaches a side it is held back, as the dashpots of "
                   "Continuum/Sides = " +
                     scene.continuum.sides.name + " have no joint";
      return names +
             (scene.bedding.slips ? " (too little slip, the more the narrower the section)"
                                  : " (a little wrong in a narrow section)") +
             "; let planes end inside, or the sides be far away";
    }


    /// The column beside an inclined plane is that of level ground.
    std::string warning_of_inclined_planes(const std::vector<PlaneEnd> &ends)
    {
      constexpr double level    = 2.; // [deg]
      const PlaneEnd  *steepest = nullptr;
      for (const PlaneEnd &end : ends)
        if (!meets_another(end, ends) && end.inclination > level &&
            (steepest == nullptr || end.inclination > steepest->inclination))
          steepest = &end;
      if (steepest == nullptr)
        return "";
      std::ostringstream text;
      text.precision(2);
      text
        << steepest->name << " meets a side at " << steepest->inclination
        << " degrees: the free-field column there has its joint, but as in level ground, and what "
           "it sends in is a little wrong (6 to 10 % of the peak at 10 degrees, 12 to 22 at 20, less "
           "with the side farther away); let the sides be far away";
      return text.str();
    }
  } // namespace


  std::vector<std::string> free_field_warnings(const SectionMesh     &mesh,
                                               const SceneParameters &scene)
  {
    std::vector<std::string> warnings;
    if (!scene.bedrock.carries_waves)
      return warnings;
    const SideBoundary &sides    = scene.continuum.sides;
    const bool          comes_in = scene.motion.type != "none" && scene.continuum.base.takes_motion;
    const auto          tell     = [&](const std::string &warning) {
      if (!warning.empty())
        warnings.push_back(warning);
    };
    if (sides.has_free_field)
      for (const char *const side : {"left", "right"})
        tell(warning_of(mesh, scene, side));
    if (comes_in && sides.has_dashpots() && !sides.has_free_field)
      tell(warning_of_dashpots(mesh));
    if (comes_in && sides.is_held())
      tell(warning_of_held_sides(scene));
    if (!comes_in || !sides.has_dashpots())
      return warnings;
    const std::vector<PlaneEnd> ends = ends_on_sides(mesh, scene);
    tell(warning_of_held_planes(scene, ends));
    if (sides.has_free_field)
      tell(warning_of_inclined_planes(ends));
    return warnings;
  }
} // namespace hybrid::scene
