// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model_builder.h>
#include <hybrid/dda/polygon.h>
#include <hybrid/dda/start_accelerations.h>
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/weibull.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace hybrid::dda
{
  namespace
  {
    using scene::SceneParameters;
    using scene::SectionMesh;

    class Builder
    {
    public:
      Builder(const SectionMesh       &section,
              const SceneParameters   &parameters,
              const std::vector<Vec2> &base_nodes)
        : mesh(section)
        , scene(parameters)
        , damping_time(parameters.blocks.damping_ratio /
                       (M_PI * parameters.blocks.damping_frequency))
      {
        model.initial.base_nodes = base_nodes;
      }

      Model build()
      {
        add_outlines();
        add_blocks();
        if (scene.blocks.bonded)
          add_block_joints();
        add_belt_joints();
        correct_stiffness();
        add_contact_laws();
        add_neighbours();
        model.newmark             = scene.time.newmark;
        model.gravity             = scene.environment.gravity;
        model.dynamic_coefficient = scene.time.dynamic_coefficient;
        model.joint_damping_time  = damping_time;
        set_water();
        model.iteration = {scene.blocks.maximum_iterations,
                           scene.blocks.tolerance,
                           scene.time.maximum_displacement_ratio};
        return std::move(model);
      }

    private:
      const SectionMesh     &mesh;
      const SceneParameters &scene;
      const double           damping_time;
      Model                  model;

      /// Material of the body or belt at elevation @p y.
      const Material &material(const bool belt, const bool saturated) const
      {
        const scene::BlockParameters &b   = scene.blocks;
        const std::string            &dry = belt ? b.belt_material : b.material;
        const std::string            &wet = belt ? b.saturated_belt_material : b.saturated_material;
        return scene.material(saturated && !wet.empty() ? wet : dry,
                              belt ? "Blocks/Belt material" : "Blocks/Material");
      }

      /// The same with the modulus of block @p b.
      Material block_material(const int b) const
      {
        Material m = material(false, model.blocks[b].saturated);
        m.young_modulus *= model.blocks[b].modulus_factor;
        return m;
      }

      /// Factor of a property with Weibull's @p shape (0: 1) at a place; @p property is a number of
      /// its own.
      double factor(const double shape, const int property, std::vector<Vec2> places) const
      {
        if (shape == 0.)
          return 1.;
        const std::uint64_t seed =
          16 * static_cast<std::uint64_t>(scene.heterogeneity.seed) + property;
        return scene::Weibull(shape).quantile(scene::number_of_place(seed, std::move(places)));
      }

      bool below_water(const Vec2 &x) const
      {
        return x.y() < scene.environment.water_level;
      }

      void add_outlines();
      void add_blocks();
      void add_block_joints();
      void add_belt_joints();
      void correct_stiffness();
      void add_contact_laws();
      void add_neighbours();

      /// @param ends of the joint [m]
      void add_joint(const Joint               &joint_without_law,
                     const Material            &strength,
                     double                     height,
                     bool                       belt,
                     const std::array<Vec2, 2> &ends);

      double softer_modulus(int block, int other) const;

      /// Part of a joint's compliance that its first block takes [-].
      double share_of_joint(const Joint &joint) const;

      void set_water();
    };



    void Builder::add_outlines()
    {
      Geometry &g = model.initial;
      g.offset.push_back(0);
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        {
          for (const int node : mesh.blocks[b])
            {
              g.vertices.push_back(mesh.nodes[node]);
              g.block_of.push_back(static_cast<int>(b));
            }
          g.offset.push_back(static_cast<int>(g.vertices.size()));
        }
    }



    void Builder::add_blocks()
    {
      const Geometry &g = model.initial;
      for (int b = 0; b < g.n_blocks(); ++b)
        {
          const PolygonMoments moments =
            polygon_moments(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b]);
          BlockProperties p;
          p.saturated       = below_water(moments.centroid);
          const Material &m = material(false, p.saturated);
          p.area            = moments.area;
          p.size            = std::sqrt(p.area);
          p.mass            = m.density * p.area;
          p.weight          = m.weighing_density() * p.area;
          p.sxx             = m.density * moments.sxx;
          p.sxy             = m.density * moments.sxy;
          p.syy             = m.density * moments.syy;
          p.modulus_factor =
            factor(scene.heterogeneity.modulus_shape,
                   0,
                   {g.vertices.begin() + g.offset[b], g.vertices.begin() + g.offset[b + 1]});
          p.damping_time = damping_time;
          p.region       = mesh.block_region.empty() ? 0 : mesh.block_region[b];
          model.blocks.push_back(p);
          model.blocks.back().elasticity = block_elasticity(block_material(b), {});
        }
      model.bonded.assign(model.blocks.size(), false);
    }



    void Builder::set_water()
    {
      using Method                               = scene::WaterMethod;
      const scene::EnvironmentParameters &around = scene.environment;
      if (around.water_method == Method::paper || around.gravity == 0.)
        return;
      model.water = {around.water_method == Method::submerged ? Water::Action::buoyancy
                                                              : Water::Action::pressures,
                     around.water_level,
                     around.water_density * around.gravity};
    }



    double Builder::softer_modulus(const int block, const int other) const
    {
      const double e = block_material(block).young_modulus;
      return other == base_body ? e : std::min(e, block_material(other).young_modulus);
    }



    void Builder::add_joint(const Joint               &joint,
                            const Material            &strength,
                            const double               height,
                            const bool                 belt,
                            const std::array<Vec2, 2> &ends)
    {
      const double k_n =
        scene.blocks.penalty_ratio * softer_modulus(joint.block, joint.other) / height;
      const double varied =
        factor(scene.heterogeneity.strength_shape, belt ? 2 : 1, {ends.begin(), ends.end()});
      Material m = strength;
      m.cohesion *= varied;
      m.residual_cohesion *= varied;
      m.tensile_strength *= varied;
      model.joints.push_back(joint);
      model.joints.back().strength_factor = varied;
      model.joints.back().law             = JointLaw(
        JointStrength::bond(m, scene.blocks.fracture_energy, scene.blocks.softening_slip, belt),
        k_n,
        scene.blocks.shear_ratio * k_n);
      model.bonded[joint.block] = true;
      if (joint.other != base_body)
        model.bonded[joint.other] = true;
    }



    void Builder::add_block_joints()
    {
      const Geometry                    &g = model.initial;
      std::map<std::pair<int, int>, int> open_edges; // (first node, second node) -> first vertex
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        {
          const auto &nodes = mesh.blocks[b];
          for (std::size_t k = 0; k < nodes.size(); ++k)
            {
              const int  from = nodes[k], to = nodes[(k + 1) % nodes.size()];
              const int  vertex = g.offset[b] + static_cast<int>(k);
              const auto twin   = open_edges.find({to, from});
              if (twin == open_edges.end())
                {
                  open_edges[{from, to}] = vertex;
                  continue;
                }
              const int    edge = twin->second;
              const Vec2   a = g.vertices[edge], e = g.vertices[g.next(edge)];
              const double length = (e - a).norm();
              const int    first  = g.block_of[edge];
              Joint        joint{first,
                          edge,
                          static_cast<int>(b),
                          length,
                          {{0., g.next(vertex)}, {1., vertex}},
                          {{}, 1., 1.}};
              add_joint(joint,
                        material(false, below_water(0.5 * (a + e))),
                        (model.blocks[first].area + model.blocks[b].area) / length,
                        false,
                        {a, e});
              open_edges.erase(twin);
            }
        }
    }



    void Builder::add_belt_joints()
    {
      const auto line = mesh.lines.find("sliding_surface");
      if (line == mesh.lines.end() || scene.blocks.belt_material.empty() ||
          model.initial.base_nodes.size() < 2)
        return;
      const Geometry                          &g = model.initial;
      std::map<std::pair<double, double>, int> base_at;
      for (std::size_t k = 0; k < g.base_nodes.size(); ++k)
        base_at[{g.base_nodes[k].x(), g.base_nodes[k].y()}] = static_cast<int>(k);

      std::map<std::pair<int, int>, bool> on_surface;
      for (const auto &edge : line->second)
        on_surface[{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}] = true;

      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        {
          const auto &nodes = mesh.blocks[b];
          for (std::size_t k = 0; k < nodes.size(); ++k)
            {
              const int from = nodes[k], to = nodes[(k + 1) % nodes.size()];
              if (on_surface.count({std::min(from, to), std::max(from, to)}) == 0)
                continue;
              const Vec2 a = mesh.nodes[from], e = mesh.nodes[to];
              const auto start = base_at.find({a.x(), a.y()}), end = base_at.find({e.x(), e.y()});
              if (start == base_at.end() || end == base_at.end() || start->second >= end->second)
                throw InputError(
                  "the mesh's line 'sliding_surface' and the bedrock's surface do not share "
                  "the node at (" +
                  std::to_string(a.x()) + ", " + std::to_string(a.y()) +
                  "): blocks must lie above the bedrock and share its edges");
              const double length = (e - a).norm();
              for (int node = start->second; node < end->second; ++node)
                {
                  const Vec2   p = g.base_nodes[node], q = g.base_nodes[node + 1];
                  const double from_a = (p - a).norm() / length, to_a = (q - a).norm() / length;
                  Joint        joint{static_cast<int>(b),
                              g.offset[b] + static_cast<int>(k),
                              base_body,
                              (q - p).norm(),
                              {{from_a, node}, {to_a, node + 1}},
                              {{}, 1., 1.}};
                  add_joint(joint,
                            material(true, below_water(0.5 * (p + q))),
                            2. * model.blocks[b].area / length,
                            true,
                            {p, q});
                }
            }
        }
    }



    double Builder::share_of_joint(const Joint &joint) const
    {
      // Joints are made of the softer side's stiffness: where moduli scatter, half of such a joint
      // would be more compliance than a stiff block has.
      if (scene.heterogeneity.modulus_shape == 0.)
        return 0.5;
      const double e = block_material(joint.block).young_modulus;
      const double f = block_material(joint.other).young_modulus;
      return f / (e + f);
    }



    void Builder::correct_stiffness()
    {
      if (!scene.blocks.stiffness_correction)
        return;
      std::vector<JointCompliance> around(model.blocks.size());
      for (const Joint &joint : model.joints)
        {
          const double kn = joint.law.normal_stiffness(), ks = joint.law.shear_stiffness();
          const auto   add = [&](const int block, const double share) {
            const double density = share * joint.length / model.blocks[block].area;
            around[block].stretch += density / kn;
            around[block].shear += 0.5 * density * (1. / kn + 1. / ks);
          };
          // A joint between blocks is shared; the bedrock takes no share of a belt joint.
          const double share = joint.other == base_body ? 1. : share_of_joint(joint);
          add(joint.block, share);
          if (joint.other != base_body)
            add(joint.other, 1. - share);
        }
      for (std::size_t b = 0; b < model.blocks.size(); ++b)
        model.blocks[b].elasticity = block_elasticity(block_material(b), around[b]);
    }



    void Builder::add_contact_laws()
    {
      for (const BlockProperties &p : model.blocks)
        {
          const Material &m = material(false, p.saturated);
          const double    k_n =
            scene.blocks.penalty_ratio * m.young_modulus * p.modulus_factor / p.size;
          const double k_s = scene.blocks.shear_ratio * k_n;
          model.block_contact.push_back(
            {JointLaw(JointStrength::broken(m), k_n, k_s), 0.5 * p.size});
          JointStrength base = JointStrength::broken(m);
          if (!scene.blocks.belt_material.empty())
            {
              base         = JointStrength::bond(material(true, p.saturated), 0., 0., true);
              base.tensile = 0.;
            }
          model.base_contact.push_back({JointLaw(base, k_n, k_s), 0.5 * p.size});
        }
    }



    void Builder::add_neighbours()
    {
      std::map<int, std::vector<int>> blocks_at;
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
        for (const int node : mesh.blocks[b])
          blocks_at[node].push_back(static_cast<int>(b));
      model.neighbours.resize(mesh.blocks.size());
      for (const auto &at : blocks_at)
        for (const int i : at.second)
          for (const int j : at.second)
            if (i != j)
              model.neighbours[i].push_back(j);
      for (auto &list : model.neighbours)
        {
          std::sort(list.begin(), list.end());
          list.erase(std::unique(list.begin(), list.end()), list.end());
        }
    }
  } // namespace



  Model build_model(const SectionMesh       &mesh,
                    const SceneParameters   &scene,
                    const std::vector<Vec2> &base_nodes)
  {
    return Builder(mesh, scene, base_nodes).build();
  }



  DdaState initial_state(const Model &model)
  {
    DdaState state;
    state.geometry = model.initial;
    state.blocks.resize(model.blocks.size());
    const Geometry &g = state.geometry;
    for (int b = 0; b < g.n_blocks(); ++b)
      state.blocks[b].centroid =
        polygon_moments(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b]).centroid;
    state.joints.resize(model.joints.size());
    const Eigen::Index n     = 2 * model.n_base_nodes();
    state.base_displacement  = Eigen::VectorXd::Zero(n);
    state.base_force         = Eigen::VectorXd::Zero(n);
    state.static_force       = Eigen::VectorXd::Zero(n);
    state.base_contact_force = Eigen::VectorXd::Zero(n);
    start_accelerations(model, state);
    return state;
  }
} // namespace hybrid::dda
