// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/coupling/block_foundation.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hybrid::coupling
{
  namespace
  {
    using dda::BoundaryEdge;
    using dda::BoundaryPart;
    using scene::SceneParameters;

    constexpr int forces_per_edge = 2 * BoundaryEdge::n_points;

    /// Of the lowest layer, of the nodes below triangles, or of the wave that comes in.
    scene::GroundMotion motion_of_base(const SceneParameters     &scene,
                                       const scene::GroundMotion &motion)
    {
      return scene.continuum.base.takes_motion ? motion : scene::GroundMotion();
    }
  } // namespace



  BlockFoundation::BlockFoundation(std::vector<Vec2>          nodes,
                                   const scene::GroundMotion &ground_motion,
                                   const SceneParameters     &scene,
                                   const dda::Model          &blocks)
    : boundary(blocks.boundary)
    , below(std::move(nodes), motion_of_base(scene, ground_motion))
    , motion(motion_of_base(scene, ground_motion))
    , compliant(scene.has_compliant_base())
    , line(scene.continuum.degree)
    , damping_time(scene.continuum.rayleigh_stiffness)
    , newmark(scene.time.newmark)
    , maxwell(maxwell_body(scene.maxwell.bedrock_ratio,
                           {scene.maxwell.lowest, scene.maxwell.highest},
                           scene.maxwell.branches))
  {
    if (scene.continuum.sides.has_free_field)
      for (const BoundaryPart side : {BoundaryPart::left, BoundaryPart::right})
        add_column(side, scene, blocks);
    at_end.branches.resize(maxwell.n_branches() * at_end.displacement.size());
  }



  continuum::FreeFieldColumn::Model
  BlockFoundation::column_model(const BoundaryEdge &lowest, const SceneParameters &scene) const
  {
    continuum::FreeFieldColumn::Model column;
    column.foot    = compliant ? continuum::Foot::impedance : continuum::Foot::prescribed;
    double nearest = 1e300; // the base's edge at the foot
    for (const BoundaryEdge &edge : boundary)
      {
        const double distance = (edge.ends[0] - lowest.ends[0]).norm();
        if (edge.part == BoundaryPart::base && distance < nearest)
          {
            nearest               = distance;
            column.foot_impedance = Vec2(edge.s_impedance, edge.p_impedance);
          }
      }
    column.newmark            = newmark;
    column.rayleigh_stiffness = damping_time;
    column.maxwell            = maxwell;
    column.joints.stiffness   = {scene.bedding.normal_stiffness, scene.bedding.shear_stiffness};
    column.joints.strength    = continuum::strength_of(scene.bedding);
    column.joints_relax       = false; // as those of the blocks
    return column;
  }



  std::optional<continuum::ColumnJoint> BlockFoundation::add_joint(const dda::Model &blocks,
                                                                   const Vec2       &place)
  {
    const dda::Geometry    &g = blocks.initial;
    std::optional<JointEnd> found;
    Vec2                    tangent(1., 0.);
    for (std::size_t j = 0; j < blocks.joints.size(); ++j)
      {
        const dda::Joint &joint = blocks.joints[j];
        if (joint.kind != dda::JointKind::bedding)
          continue;
        const Vec2 of_edge[2] = {g.vertices[joint.edge], g.vertices[g.next(joint.edge)]};
        for (int end = 0; end < 2; ++end)
          if (of_edge[end] == place)
            {
              if (found.has_value()) // planes meet each other
                return std::nullopt;
              found   = JointEnd{static_cast<int>(j), end};
              tangent = (of_edge[1 - end] - place).normalized();
            }
      }
    if (!found.has_value())
      return std::nullopt;
    ends.push_back(*found);
    return continuum::ColumnJoint{0,
                                  tangent.x() > 0. ? tangent : Vec2(-tangent),
                                  static_cast<int>(ends.size()) - 1};
  }



  void BlockFoundation::add_column(const BoundaryPart     side,
                                   const SceneParameters &scene,
                                   const dda::Model      &blocks)
  {
    std::vector<int> edges;
    const auto       bottom = [&](const int e) {
      return std::min(boundary[e].ends[0].y(), boundary[e].ends[1].y());
    };
    for (std::size_t e = 0; e < boundary.size(); ++e)
      if (boundary[e].part == side)
        edges.push_back(static_cast<int>(e));
    std::sort(edges.begin(), edges.end(), [&](const int e, const int f) {
      return bottom(e) < bottom(f);
    });

    const int                         offset = static_cast<int>(at_end.displacement.size());
    continuum::FreeFieldColumn::Model column = column_model(boundary[edges.front()], scene);
    for (const int e : edges)
      {
        const BoundaryEdge &edge = boundary[e];
        const double        low = bottom(e), top = std::max(edge.ends[0].y(), edge.ends[1].y());
        const bool          gap = !column.elements.empty() &&
                         std::abs(low - column.elements.back().top) > 1e-9 * (top - low);
        if (gap || std::abs(edge.normal().y()) > 1e-6)
          throw InputError("Continuum/Sides = " + scene.continuum.sides.name +
                           " needs vertical sides in one piece; the side near (" +
                           std::to_string(edge.ends[0].x()) + ", " + std::to_string(low) +
                           ") is not.");
        const int   element        = static_cast<int>(column.elements.size());
        const Vec2 &bottom_of_edge = edge.ends[edge.ends[0].y() < edge.ends[1].y() ? 0 : 1];
        if (auto joint = element > 0 ? add_joint(blocks, bottom_of_edge) : std::nullopt)
          {
            joint->element = element;
            column.joints.joints.push_back(*joint);
          }
        const int n_joints = static_cast<int>(column.joints.joints.size());
        sides.push_back({e, offset + 2 * (element * line.degree() + n_joints)});
        column.elements.push_back({low, top, edge.density, edge.lambda, edge.shear});
      }
    column_offset.push_back(offset);
    columns.emplace_back(line, column);
    for (std::vector<double> *values :
         {&at_end.displacement, &at_end.velocity, &at_end.acceleration})
      values->resize(offset + 2 * columns.back().n_nodes());
    if (newmark.filter > 0.)
      at_end.change.resize(at_end.acceleration.size());
  }



  void BlockFoundation::start(CoupledState &state) const
  {
    const std::vector<double> zero(at_end.displacement.size(), 0.);
    state.columns          = {zero, zero, zero, {}, 0., {}, {}, {}, {}};
    state.columns.change   = std::vector<double>(at_end.change.size(), 0.);
    state.columns.branches = std::vector<double>(at_end.branches.size(), 0.);
    if (!slips())
      return;
    for (const continuum::FreeFieldColumn &column : columns)
      state.columns.slip.push_back(column.plane_joints().initial_state());
    state.columns.rest        = std::vector<double>(2 * ends.size(), 0.);
    state.columns.rest_failed = std::vector<char>(ends.size(), 0);
  }



  bool BlockFoundation::slips() const
  {
    return std::any_of(columns.begin(), columns.end(), [](const auto &column) {
      return column.plane_joints().slips();
    });
  }



  void BlockFoundation::take_rest(CoupledState &state) const
  {
    for (std::size_t k = 0; k < ends.size() && slips(); ++k)
      {
        const dda::SpringState &end   = state.blocks.joints[ends[k].joint].points[ends[k].point];
        state.columns.rest[2 * k]     = -end.elastic_normal;
        state.columns.rest[2 * k + 1] = end.elastic_shear;
        state.columns.rest_failed[k]  = end.history.damage >= 1.;
      }
  }



  void BlockFoundation::step_columns(const CoupledState &state, const double dt)
  {
    const double                            time  = state.time + dt;
    const bool                              keeps = newmark.filter > 0.;
    const bool                              damps = maxwell.n_branches() > 0;
    const continuum::FreeFieldColumn::Input input{motion.upgoing_velocity(time),
                                                  motion.outcrop_acceleration(time)};
    columns_settled = true;
    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        const int o = column_offset[c];
        if (columns[c].plane_joints().slips())
          columns[c].plane_joints().set_rest(state.columns.rest, state.columns.rest_failed);
        columns_settled &=
          columns[c].step({state.columns.displacement.data() + o,
                           state.columns.velocity.data() + o,
                           state.columns.acceleration.data() + o,
                           keeps ? state.columns.change.data() + o : nullptr,
                           state.columns.last_step,
                           damps ? state.columns.branches.data() + o : nullptr,
                           at_end.displacement.size()},
                          {at_end.displacement.data() + o,
                           at_end.velocity.data() + o,
                           at_end.acceleration.data() + o,
                           keeps ? at_end.change.data() + o : nullptr,
                           damps ? at_end.branches.data() + o : nullptr},
                          dt,
                          input,
                          state.columns.slip.empty() ? nullptr : &state.columns.slip[c]);
      }
  }



  void BlockFoundation::set_forces(const double time)
  {
    response.boundary_force.setZero(forces_per_edge * static_cast<Eigen::Index>(boundary.size()));
    if (!motion.empty())
      {
        const Vec2 twice_upgoing = 2. * motion.upgoing_velocity(time);
        for (std::size_t e = 0; e < boundary.size(); ++e)
          if (boundary[e].part == BoundaryPart::base)
            {
              const Vec2 force = boundary[e].weight() * boundary[e].impedance() * twice_upgoing;
              for (int k = 0; k < BoundaryEdge::n_points; ++k)
                response.boundary_force.segment<2>(forces_per_edge * e + 2 * k) = force;
            }
      }
    for (const BesideColumn &side : sides)
      add_column_forces(side);
  }



  double BlockFoundation::stressed(const std::size_t unknown) const
  {
    double sum = maxwell.relaxed * at_end.displacement[unknown];
    for (std::size_t l = 0; l < maxwell.n_branches(); ++l)
      sum += maxwell.weight[l] * at_end.branches[l * at_end.displacement.size() + unknown];
    return sum;
  }



  void BlockFoundation::add_column_forces(const BesideColumn &side)
  {
    const BoundaryEdge &edge   = boundary[side.edge];
    const double        length = (edge.ends[1] - edge.ends[0]).norm();
    const bool          upward = edge.ends[1].y() > edge.ends[0].y();
    for (int k = 0; k < BoundaryEdge::n_points; ++k)
      {
        const double x = upward ? BoundaryEdge::position(k) : 1. - BoundaryEdge::position(k);
        Vec2         velocity(0., 0.), slope(0., 0.); // slope of u + beta_K v along y
        for (int i = 0; i <= line.degree(); ++i)
          {
            const int  node = side.first + 2 * i;
            const Vec2 ui(stressed(node), stressed(node + 1)),
              vi(at_end.velocity[node], at_end.velocity[node + 1]);
            velocity += line.value(i, x) * vi;
            slope += line.derivative(i, x) / length * (ui + damping_time * vi);
          }
        const Vec2 stress(edge.normal().x() * edge.lambda * slope.y(),
                          edge.normal().x() * edge.shear * slope.x());
        response.boundary_force.segment<2>(forces_per_edge * side.edge + 2 * k) =
          edge.weight() * (stress + edge.impedance() * velocity);
      }
  }



  const dda::FoundationResponse &BlockFoundation::predict(const CoupledState &state,
                                                          const double        dt)
  {
    step_columns(state, dt);
    response.displacement = below.predict(state, dt).displacement;
    set_forces(state.time + dt);
    return response;
  }



  continuum::SlipStatus
  BlockFoundation::solve_slip(const CoupledState &, double, const Eigen::VectorXd &)
  {
    return columns_settled ? continuum::SlipStatus::settled : continuum::SlipStatus::failed;
  }



  void BlockFoundation::correct(CoupledState &state,
                                const double  dt,
                                const Eigen::VectorXd &,
                                const continuum::SurfaceForce &)
  {
    at_end.slip        = state.columns.slip;
    at_end.rest        = state.columns.rest;
    at_end.rest_failed = state.columns.rest_failed;
    for (std::size_t c = 0; c < at_end.slip.size(); ++c)
      if (columns[c].plane_joints().slips())
        columns[c].plane_joints().keep(at_end.slip[c]);
    state.columns           = at_end;
    state.columns.last_step = newmark.filter > 0. ? dt : 0.;
  }
} // namespace hybrid::coupling
