// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/boundary_forces.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hybrid::continuum
{
  namespace
  {
    std::vector<RockFace>
    required_faces(const RockMesh &rock, const scene::SectionMesh &section, const std::string &name)
    {
      const auto line = section.lines.find(name);
      if (line == section.lines.end() || line->second.empty())
        throw InputError("Mesh: the continuum needs a line named '" + name +
                         "', and there is none.");
      auto faces = boundary_faces(rock, line->second);
      if (faces.size() != line->second.size())
        throw InputError("Mesh: " + std::to_string(line->second.size() - faces.size()) +
                         " of the " + std::to_string(line->second.size()) + " edges of line '" +
                         name + "' are not on the boundary of the bedrock.");
      return faces;
    }

    double s_impedance(const Material &m)
    {
      return std::sqrt(m.density * m.shear_modulus());
    }

    double p_impedance(const Material &m)
    {
      return std::sqrt(m.density * (m.lame_lambda() + 2. * m.shear_modulus()));
    }

    /// The plane that lies between two nodes at one place, where it ends; none if nothing parts
    /// them, or more than one plane.
    std::optional<ColumnJoint>
    plane_between(const RockMesh &rock, const int node, const int other, const int degree)
    {
      for (std::size_t f = 0; f < rock.joints.size() && node != other; ++f)
        {
          const RockFace &first = rock.joints[f].first, &second = rock.joints[f].second;
          for (const auto &[one, two, far] : {std::array<int, 3>{first.a, second.a, first.b},
                                              std::array<int, 3>{first.b, second.b, first.a}})
            if ((one == node && two == other) || (one == other && two == node))
              {
                // Tangents run to +x, points along them (BeddingPlanes).
                const Vec2 inwards = (rock.nodes[far] - rock.nodes[node]).normalized();
                const bool starts  = inwards.x() > 0.;
                const int  points  = degree + 1;
                return ColumnJoint{0,
                                   starts ? inwards : Vec2(-inwards),
                                   static_cast<int>(f) * points + (starts ? 0 : points - 1)};
              }
        }
      return std::nullopt;
    }
  } // namespace


  BoundaryForces::BoundaryForces(const RockMesh               &rock,
                                 const ElementNodes           &element_nodes,
                                 const CellMaterials          &cell_material,
                                 const scene::SectionMesh     &section,
                                 const scene::SceneParameters &scene,
                                 scene::GroundMotion           m)
    : line(element_nodes.line)
    , elastic(element_nodes.line)
    , motion(scene.continuum.base.takes_motion ? std::move(m) : scene::GroundMotion())
    , support(2 * element_nodes.positions.size(), Support::none)
    , place(element_nodes.positions.size(), -1)
  {
    const auto base = required_faces(rock, section, "base");
    // Base last among supports, so that a corner moves with the base.
    half_space =
      scene.continuum.half_space_material.empty()
        ? cell_material[base.front().cell]
        : scene.material(scene.continuum.half_space_material, "Continuum/Half space material");
    compliant = scene.continuum.base.is_compliant;
    moves     = scene.continuum.base.moves();
    for (const char *side : {"left", "right"})
      set_side(rock, element_nodes, cell_material, required_faces(rock, section, side), scene);
    set_base(rock, element_nodes, cell_material, base, scene);
    if (scene.continuum.boundary_springs)
      set_springs(rock, element_nodes, scene.continuum);
    place = std::vector<int>();
  }


  BoundaryForces::Face BoundaryForces::make_face(const RockMesh     &rock,
                                                 const ElementNodes &element_nodes,
                                                 const RockFace     &rock_face,
                                                 const Material     &material,
                                                 const Dashpots     &dashpots)
  {
    const Vec2 along = rock.nodes[rock_face.b] - rock.nodes[rock_face.a];
    Face       face;
    face.length = along.norm();
    face.normal = Vec2(along.y(), -along.x()) / face.length;
    face.impedance =
      dashpots.normal * p_impedance(material) * face.normal * face.normal.transpose() +
      dashpots.shear * s_impedance(material) *
        (Eigen::Matrix2d::Identity() - face.normal * face.normal.transpose());
    face.is_base = false;
    face.shear   = material.shear_modulus();
    for (const int node : element_nodes.along(rock_face))
      {
        if (place[node] < 0)
          {
            place[node] = static_cast<int>(nodes.size());
            nodes.push_back(node);
          }
        face.nodes.push_back(place[node]);
      }
    return face;
  }


  void BoundaryForces::set_base(const RockMesh               &rock,
                                const ElementNodes           &element_nodes,
                                const CellMaterials          &cell_material,
                                const std::vector<RockFace>  &base,
                                const scene::SceneParameters &scene)
  {
    for (const auto &rock_face : base)
      if (compliant)
        {
          const bool named = !scene.continuum.half_space_material.empty();
          Face       face  = make_face(rock,
                                element_nodes,
                                rock_face,
                                named ? half_space : cell_material[rock_face.cell],
                                {1., 1.});
          face.is_base     = true;
          faces.push_back(face);
        }
      else
        for (const int node : element_nodes.along(rock_face))
          {
            if (moves && support[2 * node] != Support::base_motion)
              moving.push_back(node);
            support[2 * node] = support[2 * node + 1] =
              moves ? Support::base_motion : Support::zero;
          }
  }


  void BoundaryForces::set_side(const RockMesh               &rock,
                                const ElementNodes           &element_nodes,
                                const CellMaterials          &cell_material,
                                std::vector<RockFace>         side,
                                const scene::SceneParameters &scene)
  {
    const scene::SideBoundary &kind = scene.continuum.sides;
    for (const auto &rock_face : side)
      for (const int node : element_nodes.along(rock_face))
        for (int c = 0; c < 2; ++c)
          if (c == 0 ? kind.holds_x : kind.holds_y)
            support[2 * node + c] = Support::zero;
    if (!kind.has_dashpots())
      return;

    const bool free_field = kind.has_free_field;
    const auto middle     = [&](const RockFace &f) {
      return rock.nodes[f.a].y() + rock.nodes[f.b].y();
    };
    std::sort(side.begin(), side.end(), [&](const RockFace &f, const RockFace &g) {
      return middle(f) < middle(g);
    });
    const bool      named = !scene.continuum.half_space_material.empty();
    const Material &below = named ? half_space : cell_material[side.front().cell];

    FreeFieldColumn::Model column = column_model(below, scene);
    int                    end    = -1; ///< of the face before
    for (auto &rock_face : side)
      {
        if (rock.nodes[rock_face.a].y() > rock.nodes[rock_face.b].y())
          std::swap(rock_face.a, rock_face.b);
        const Material &material = cell_material[rock_face.cell];
        Face            face     = make_face(
          rock, element_nodes, rock_face, material, {kind.normal_dashpots, kind.shear_dashpots});
        const double x = element_nodes.map(rock_face.cell, Vec2(0.5, 0.5)).x();
        if (face.normal.x() * (rock.nodes[rock_face.a].x() - x) < 0.)
          face.normal = -face.normal;
        if (free_field)
          {
            const double bottom = rock.nodes[rock_face.a].y(), top = rock.nodes[rock_face.b].y();
            const bool   gap = !column.elements.empty() &&
                             std::abs(bottom - column.elements.back().top) > 1e-9 * face.length;
            if (std::abs(face.normal.y()) > 1e-6 || gap)
              throw InputError("Continuum/Sides = " + kind.name +
                               " needs vertical sides in one piece; the side near (" +
                               std::to_string(rock.nodes[rock_face.a].x()) + ", " +
                               std::to_string(bottom) +
                               ") is not; viscous sides may have any shape");
            const int element = static_cast<int>(column.elements.size());
            auto      joint =
              end < 0 ? std::nullopt : plane_between(rock, end, rock_face.a, line.degree());
            if (joint.has_value())
              {
                joint->element = element;
                column.joints.joints.push_back(*joint);
              }
            end         = rock_face.b;
            face.column = static_cast<int>(columns.size());
            face.column_node =
              element * line.degree() + static_cast<int>(column.joints.joints.size());
            face.lambda = material.lame_lambda();
            column.elements.push_back({bottom, top, material.density, face.lambda, face.shear});
          }
        faces.push_back(face);
      }
    if (!free_field)
      return;
    column_offset.push_back(static_cast<int>(n_column_unknowns()));
    columns.emplace_back(line, column);
  }


  FreeFieldColumn::Model BoundaryForces::column_model(const Material               &below,
                                                      const scene::SceneParameters &scene) const
  {
    FreeFieldColumn::Model column;
    column.foot               = compliant ? Foot::impedance : Foot::prescribed;
    column.foot_impedance     = Vec2(s_impedance(below), p_impedance(below));
    column.newmark            = scene.time.newmark;
    column.rayleigh_mass      = scene.continuum.rayleigh_mass;
    column.rayleigh_stiffness = scene.continuum.rayleigh_stiffness;
    column.maxwell            = maxwell_body(scene.maxwell.bedrock_ratio,
                                  {scene.maxwell.lowest, scene.maxwell.highest},
                                  scene.maxwell.branches);
    column.joints.stiffness   = {scene.bedding.normal_stiffness, scene.bedding.shear_stiffness};
    column.joints.strength    = strength_of(scene.bedding);
    return column;
  }


  void BoundaryForces::set_springs(const RockMesh                   &rock,
                                   const ElementNodes               &element_nodes,
                                   const scene::ContinuumParameters &parameters)
  {
    Vec2 low = rock.nodes.front(), high = low;
    for (const auto &node : rock.nodes)
      {
        low  = low.cwiseMin(node);
        high = high.cwiseMax(node);
      }
    const Vec2 load(0.5 * (low.x() + high.x()), high.y());
    for (const auto &face : faces)
      {
        const Vec2   middle = 0.5 * (element_nodes.positions[nodes[face.nodes.front()]] +
                                   element_nodes.positions[nodes[face.nodes.back()]]);
        const double distance =
          parameters.spring_distance > 0. ? parameters.spring_distance : (middle - load).norm();
        const Eigen::Matrix2d nn = face.normal * face.normal.transpose();
        const Eigen::Matrix2d k =
          face.shear / distance *
          (parameters.normal_spring * nn +
           parameters.tangential_spring * (Eigen::Matrix2d::Identity() - nn));
        elastic.add({face.nodes, face.length, k, face.is_base || face.column >= 0});
      }
    for (const int node : nodes)
      across.push_back((element_nodes.positions[node].x() - low.x()) / (high.x() - low.x()));
  }


  void BoundaryForces::add_dashpots(const NodeMatrices  &matrices,
                                    const double         factor,
                                    std::vector<double> &blocks) const
  {
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        for (std::size_t j = 0; j < face.nodes.size(); ++j)
          {
            const int entry = matrices.entry(nodes[face.nodes[i]], nodes[face.nodes[j]]);
            for (int k = 0; k < 4; ++k)
              blocks[4 * entry + k] +=
                factor * face.length * line.mass()(i, j) * face.impedance(k / 2, k % 2);
          }
  }


  std::vector<Eigen::Matrix2d> BoundaryForces::nodal_dashpots() const
  {
    std::vector<Eigen::Matrix2d> result(nodes.size(), Eigen::Matrix2d::Zero());
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        result[face.nodes[i]] += face.length * line.mass()(i, i) * face.impedance;
    return result;
  }


  std::size_t BoundaryForces::n_column_unknowns() const
  {
    std::size_t sum = 0;
    for (const auto &column : columns)
      sum += 2 * column.n_nodes();
    return sum;
  }


  bool BoundaryForces::step_columns(const FreeFieldColumn::ConstMotion &old,
                                    const FreeFieldColumn::Motion      &next,
                                    const double                        time,
                                    const double                        dt,
                                    const std::vector<SlipState>       &slip)
  {
    bool                   found = true;
    FreeFieldColumn::Input input;
    if (compliant)
      input.wave_velocity = motion.upgoing_velocity(time + dt);
    if (moves)
      input.acceleration = motion.outcrop_acceleration(time + dt);
    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        const int  o     = column_offset[c];
        const bool keeps = next.change != nullptr, damped = next.branch != nullptr;
        found &= columns[c].step({old.u + o,
                                  old.v + o,
                                  old.a + o,
                                  keeps ? old.change + o : nullptr,
                                  old.last_step,
                                  damped ? old.branch + o : nullptr,
                                  old.stride},
                                 {next.u + o,
                                  next.v + o,
                                  next.a + o,
                                  keeps ? next.change + o : nullptr,
                                  damped ? next.branch + o : nullptr},
                                 dt,
                                 input,
                                 slip.empty() ? nullptr : &slip[c]);
      }
    return found;
  }


  std::vector<SlipState> BoundaryForces::column_slip_at_rest() const
  {
    std::vector<SlipState> result;
    bool                   any = false;
    for (const auto &column : columns)
      {
        result.push_back(column.plane_joints().initial_state());
        any |= column.plane_joints().slips();
      }
    return any ? result : std::vector<SlipState>();
  }


  void BoundaryForces::keep_column_slip(std::vector<SlipState> &slip) const
  {
    for (std::size_t c = 0; c < slip.size(); ++c)
      if (columns[c].plane_joints().slips())
        columns[c].plane_joints().keep(slip[c]);
  }


  void BoundaryForces::set_column_rest(const std::vector<double> &traction,
                                       const std::vector<char>   &failed)
  {
    for (auto &column : columns)
      column.plane_joints().set_rest(traction, failed);
  }


  void BoundaryForces::incoming_base(const double time, const double *u, Incoming &in) const
  {
    const Vec2 wave = motion.upgoing_displacement(time);
    for (const auto &face : faces)
      for (const int k : face.nodes)
        for (int c = 0; c < 2 && face.is_base; ++c)
          in.displacement[2 * k + c] =
            columns.size() == 2
              ? (1. - across[k]) * u[column_offset[0] + c] + across[k] * u[column_offset[1] + c]
              : wave[c];
  }


  void BoundaryForces::incoming(const double  time,
                                const double *u,
                                const double *v,
                                Incoming     &in,
                                const double *stressed) const
  {
    const double *strained = stressed == nullptr ? u : stressed;
    in.force.assign(2 * nodes.size(), 0.);
    in.velocity.assign(2 * nodes.size(), 0.);
    in.displacement.assign(2 * nodes.size(), 0.);
    const Vec2 wave = compliant ? Vec2(2. * motion.upgoing_velocity(time)) : Vec2(0., 0.);
    for (const auto &face : faces)
      {
        const int n = static_cast<int>(face.nodes.size());
        if (face.is_base)
          {
            const Vec2 traction = face.impedance * wave;
            for (int i = 0; i < n; ++i)
              for (int c = 0; c < 2; ++c)
                in.force[2 * face.nodes[i] + c] +=
                  face.length * line.mass().row(i).sum() * traction[c];
          }
        else if (face.column >= 0)
          {
            const int first = column_offset[face.column] + 2 * face.column_node;
            // Stress of the column, stiffness-proportional damping included.
            const double damping = columns[face.column].description().rayleigh_stiffness;
            for (int i = 0; i < n; ++i)
              {
                double ux = 0., uy = 0.; // integrals of N_i u_,y
                for (int j = 0; j < n; ++j)
                  {
                    const int k = first + 2 * j;
                    ux += line.gradient()(i, j) * (strained[k] + damping * v[k]);
                    uy += line.gradient()(i, j) * (strained[k + 1] + damping * v[k + 1]);
                  }
                in.force[2 * face.nodes[i]] += face.normal.x() * face.lambda * uy;
                in.force[2 * face.nodes[i] + 1] += face.normal.x() * face.shear * ux;
                for (int c = 0; c < 2; ++c)
                  {
                    in.velocity[2 * face.nodes[i] + c]     = v[first + 2 * i + c];
                    in.displacement[2 * face.nodes[i] + c] = u[first + 2 * i + c];
                  }
              }
          }
      }
    if (!elastic.empty())
      incoming_base(time, u, in);
  }


  void BoundaryForces::forces(const Incoming            &in,
                              const std::vector<double> &v,
                              std::vector<double>       &f) const
  {
    f = in.force;
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        {
          Vec2 mean(0., 0.);
          for (std::size_t j = 0; j < face.nodes.size(); ++j)
            {
              const int    k = 2 * face.nodes[j];
              const double m = face.length * line.mass()(i, j);
              if (face.column >= 0)
                mean += m * Vec2(in.velocity[k] - v[k], in.velocity[k + 1] - v[k + 1]);
              else
                mean -= m * Vec2(v[k], v[k + 1]);
            }
          const Vec2 force = face.impedance * mean;
          f[2 * face.nodes[i]] += force.x();
          f[2 * face.nodes[i] + 1] += force.y();
        }
  }


  double BoundaryForces::dashpot_loss(const std::vector<double> &du,
                                      const std::vector<double> &v,
                                      const std::vector<double> &du_ff,
                                      const std::vector<double> &v_ff) const
  {
    double loss = 0.;
    for (const auto &face : faces)
      for (std::size_t i = 0; i < face.nodes.size(); ++i)
        {
          const int    a    = 2 * face.nodes[i];
          const double free = face.column >= 0 ? 1. : 0.;
          Vec2         mean(0., 0.);
          for (std::size_t j = 0; j < face.nodes.size(); ++j)
            {
              const int b = 2 * face.nodes[j];
              mean += face.length * line.mass()(i, j) *
                      Vec2(v[b] - free * v_ff[b], v[b + 1] - free * v_ff[b + 1]);
            }
          loss += Vec2(du[a] - free * du_ff[a], du[a + 1] - free * du_ff[a + 1])
                    .dot(face.impedance * mean);
        }
    return loss;
  }
} // namespace hybrid::continuum
