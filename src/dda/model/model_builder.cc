// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/held_neighbours.h>
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/dda/linear/sweep_order.h>
#include <hybrid/dda/model/bedrock_boundary.h>
#include <hybrid/dda/model/block_damping.h>
#include <hybrid/dda/model/contact_laws.h>
#include <hybrid/dda/model/joint_builder.h>
#include <hybrid/dda/model/joint_valleys.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
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
              const std::vector<Vec2> &foundation_nodes,
              const BondLaws          &chosen_laws)
        : mesh(section)
        , scene(parameters)
        , laws(chosen_laws)
        , material(section, parameters)
        , damping_time(parameters.blocks.damping_ratio /
                       (M_PI * parameters.blocks.damping_frequency))
      {
        model.initial.foundation_nodes = foundation_nodes;
      }

      Model build()
      {
        collect_blocks();
        add_outlines();
        join_bedrock_surface();
        add_blocks();
        add_joints();
        set_joint_valleys(model);
        correct_stiffness();
        set_loose_damping();
        set_maxwell_damping();
        set_contact_laws(mesh, scene, laws, materials, model);
        model.neighbours =
          held_neighbours({outlines.begin(), outlines.begin() + n_mass}, model.contacts.bonded);
        model.neighbours.resize(outlines.size());
        add_slices();
        model.soles    = find_soles(model);
        model.downhill = find_downhill(model, mesh);
        if (model.n_bedrock > 0)
          model.boundary =
            boundary_edges(mesh, scene, model.initial, {outlines, materials, n_mass});
        set_water();
        model.edge_loads = find_edge_loads(mesh, scene.edge_loads, outlines, model.initial);
        model.moving_blocks =
          find_moving_blocks(scene.blocks.initial_velocities, model.initial, n_mass);
        model.newmark              = scene.time.newmark;
        model.gravity              = scene.environment.gravity;
        model.horizontal           = scene.environment.horizontal * scene.environment.gravity;
        model.blocks_yield         = scene.blocks.yielding && n_mass > 0;
        model.dynamic_coefficient  = scene.time.dynamic_coefficient;
        model.coefficient_step     = scene.time.time_step;
        model.joint_damping_time   = damping_time;
        model.bedrock_damping_time = scene.continuum.rayleigh_stiffness;
        model.iteration            = {scene.blocks.maximum_iterations,
                                      scene.blocks.tolerance,
                                      scene.time.maximum_displacement_ratio};
        return std::move(model);
      }

    private:
      const SectionMesh            &mesh;
      const SceneParameters        &scene;
      const BondLaws               &laws;
      const BlockMaterials          material;
      const double                  damping_time;
      std::vector<std::vector<int>> outlines; ///< nodes of all blocks; mass, then bedrock
      std::vector<int>              regions;
      std::vector<Material>         materials; ///< of each block
      int                           n_mass = 0;
      Model                         model;

      void collect_blocks();
      void add_outlines();
      void join_bedrock_surface();
      void add_blocks();
      void add_joints();
      void correct_stiffness();

      /// Of a block among joints of this compliance [Pa].
      /// @throws InputError that names the block if the joints alone are softer than its material
      Eigen::Matrix3d elasticity_between(int block, const JointCompliance &joints);

      void set_loose_damping();
      void set_maxwell_damping();
      void add_slices();
      void set_water();

      /// On the cohesion inside a block of the mass [-].
      double strength_factor(int block) const;

      /// Part of a joint's compliance that its first block takes [-].
      double share_of_joint(const Joint &joint) const;
    };



    void Builder::collect_blocks()
    {
      if (scene.blocks.enabled)
        {
          outlines = mesh.blocks;
          regions  = mesh.block_region;
        }
      n_mass = static_cast<int>(outlines.size());
      regions.resize(n_mass, 0);
      const scene::BedrockBlocks bedrock = scene::cut_bedrock(mesh, scene);
      outlines.insert(outlines.end(), bedrock.outlines.begin(), bedrock.outlines.end());
      for (const int region : bedrock.region)
        regions.push_back(static_cast<int>(mesh.block_region_names.size()) + region);
      model.n_bedrock = static_cast<int>(bedrock.outlines.size());
    }



    void Builder::add_outlines()
    {
      Geometry &g = model.initial;
      g.offset.push_back(0);
      for (std::size_t b = 0; b < outlines.size(); ++b)
        {
          for (const int node : outlines[b])
            {
              g.vertices.push_back(mesh.nodes[node]);
              g.block_of.push_back(static_cast<int>(b));
            }
          g.offset.push_back(static_cast<int>(g.vertices.size()));
        }
    }



    void Builder::join_bedrock_surface()
    {
      if (model.n_bedrock == 0)
        return;
      Geometry &g = model.initial;
      // Edges of the bedrock by their nodes, and where those of the surface begin.
      std::map<std::pair<int, int>, int> edges;
      const auto                         for_each_edge = [&](const auto &act) {
        for (std::size_t b = n_mass; b < outlines.size(); ++b)
          for (std::size_t k = 0; k < outlines[b].size(); ++k)
            act(g.offset[b] + static_cast<int>(k),
                outlines[b][k],
                outlines[b][(k + 1) % outlines[b].size()]);
      };
      for_each_edge([&](const int v, const int from, const int to) { edges[{from, to}] = v; });

      g.bedrock.first_block = n_mass;
      g.bedrock.next.resize(g.vertices.size());
      g.bedrock.previous.resize(g.vertices.size());
      for (int v = 0; v < static_cast<int>(g.vertices.size()); ++v)
        {
          const bool is_mass    = g.block_of[v] < n_mass;
          g.bedrock.next[v]     = is_mass ? g.next(v) : BedrockSurface::inside;
          g.bedrock.previous[v] = is_mass ? g.previous(v) : BedrockSurface::none;
        }
      std::map<int, int> begin_at; // node, first vertex
      const auto         is_outside = [&](const int from, const int to) {
        return edges.count({to, from}) == 0;
      };
      for_each_edge([&](const int v, const int from, const int to) {
        if (is_outside(from, to))
          begin_at[from] = v;
      });
      for_each_edge([&](const int v, const int from, const int to) {
        if (!is_outside(from, to))
          return;
        const auto next   = begin_at.find(to);
        g.bedrock.next[v] = next == begin_at.end() ? BedrockSurface::none : next->second;
        if (next != begin_at.end())
          g.bedrock.previous[next->second] = v;
      });
    }



    void Builder::add_blocks()
    {
      const Geometry &g = model.initial;
      model.blocks.reserve(g.n_blocks());
      materials.reserve(g.n_blocks());
      for (int b = 0; b < g.n_blocks(); ++b)
        {
          const PolygonMoments moments =
            polygon_moments(&g.vertices[g.offset[b]], g.offset[b + 1] - g.offset[b]);
          const bool      bedrock = b >= n_mass;
          BlockProperties p;
          p.region         = regions[b];
          p.saturated      = !bedrock && material.below_water(moments.centroid);
          Material m       = bedrock
                               ? scene.bedrock_material(
                             mesh.bedrock_region_names[p.region - mesh.block_region_names.size()])
                               : material.mass(p.region, p.saturated);
          p.area           = moments.area;
          p.size           = std::sqrt(p.area);
          p.mass           = m.density * p.area;
          p.weight         = bedrock ? 0. : m.weighing_density() * p.area;
          p.pushed_mass    = bedrock ? 0. : p.mass;
          p.weight_at_rest = bedrock ? m.weighing_density() * p.area : 0.;
          p.sxx            = m.density * moments.sxx;
          p.sxy            = m.density * moments.sxy;
          p.syy            = m.density * moments.syy;
          if (!bedrock)
            p.modulus_factor = material.factor(scene.heterogeneity.modulus_shape,
                                               BlockMaterials::modulus_number,
                                               {g.vertices.begin() + g.offset[b],
                                                g.vertices.begin() + g.offset[b + 1]});
          m.young_modulus *= p.modulus_factor;
          p.elasticity = block_elasticity(m, {});
          if (scene.blocks.yielding && !bedrock)
            p.strength = block_strength(m, strength_factor(b));
          p.damping_time = bedrock ? scene.continuum.rayleigh_stiffness : damping_time;
          model.blocks.push_back(p);
          materials.push_back(m);
        }
      model.bonded.assign(model.blocks.size(), false);
    }



    double Builder::strength_factor(const int block) const
    {
      const Geometry &g = model.initial;
      return material.factor(scene.heterogeneity.strength_shape,
                             BlockMaterials::block_strength_number,
                             {g.vertices.begin() + g.offset[block],
                              g.vertices.begin() + g.offset[block + 1]});
    }



    void Builder::add_joints()
    {
      const JointedBlocks blocks{outlines, materials, n_mass};
      JointBuilder        joints(mesh, scene, laws, blocks, model);
      joints.add_block_joints();
      joints.add_belt_joints();
      if (model.n_bedrock > 0)
        joints.add_foundation_joints();
      model.joints.shrink_to_fit();
    }



    void Builder::set_water()
    {
      using Method                               = scene::WaterMethod;
      const scene::EnvironmentParameters &around = scene.environment;
      if (around.water_method == Method::paper || around.gravity == 0. || !around.has_water())
        return;
      const auto shared = [](const scene::LinearTable &table) {
        return table.empty() ? nullptr : std::make_shared<const scene::LinearTable>(table);
      };
      model.water = {around.water_method == Method::submerged ? Water::Action::buoyancy
                                                              : Water::Action::pressures,
                     around.water_level,
                     around.water_density * around.gravity,
                     shared(around.water_tables.line),
                     shared(around.water_tables.level),
                     around.static_water == scene::WaterPlace::drawn};
    }



    double Builder::share_of_joint(const Joint &joint) const
    {
      // Joints are made of the softer side's stiffness: half of such a joint may be more compliance
      // than the stiffer block has.
      const double e = materials[joint.block].young_modulus;
      const double f = materials[joint.other].young_modulus;
      return f / (e + f);
    }



    void Builder::correct_stiffness()
    {
      if (!scene.blocks.stiffness_correction)
        return;
      std::vector<JointCompliance> around(model.blocks.size());
      for (const Joint &joint : model.joints)
        {
          // Bedding planes are soft by themselves; welds between layers are no jointed mass.
          if (joint.kind == JointKind::bedding ||
              (joint.kind == JointKind::weld && !scene.bedrock.carries_waves))
            continue;
          const double kn = joint.law.normal_stiffness(), ks = joint.law.shear_stiffness();
          const auto   add = [&](const int block, const double share) {
            const double density = share * joint.length / model.blocks[block].area;
            around[block].stretch += density / kn;
            around[block].shear += 0.5 * density * (1. / kn + 1. / ks);
          };
          // A joint between blocks is shared; the bedrock takes no share of a belt joint.
          const bool   shared = joint.other != foundation_body && joint.kind != JointKind::belt;
          const double share  = shared ? share_of_joint(joint) : 1.;
          add(joint.block, share);
          if (shared)
            add(joint.other, 1. - share);
        }
      for (std::size_t b = 0; b < model.blocks.size(); ++b)
        model.blocks[b].elasticity = elasticity_between(static_cast<int>(b), around[b]);
    }



    Eigen::Matrix3d Builder::elasticity_between(const int block, const JointCompliance &joints)
    {
      try
        {
          return block_elasticity(materials[block], joints);
        }
      catch (const InputError &reason)
        {
          const BlockProperties &p = model.blocks[block];
          const Vec2            &x = model.initial.vertices[model.initial.offset[block]];
          std::ostringstream     text;
          text.precision(3);
          text << reason.what() << ". This is block "
               << (block < n_mass ? mesh.block_name(block) : std::to_string(block)) << " at ("
               << x.x() << ", " << x.y() << ") m, of " << p.area
               << " m2; joints of a block that is small beside its neighbours are soft for it: "
                  "give it another shape, or set Blocks/Stiffness correction = false";
          throw InputError(text.str());
        }
    }



    void Builder::set_loose_damping()
    {
      model.damps_loose = scene.blocks.loose_damping > 0.;
      for (int b = 0; b < n_mass; ++b)
        model.blocks[b].loose_damping_time =
          scene.blocks.loose_damping * critical_damping_time(model.blocks[b]);
    }



    void Builder::set_maxwell_damping()
    {
      const scene::MaxwellParameters &given      = scene.maxwell;
      const bool                      of_mass    = given.block_ratio > 0. && n_mass > 0;
      const bool                      of_bedrock = given.bedrock_ratio > 0. && model.n_bedrock > 0;
      if (!of_mass && !of_bedrock)
        return;
      const FrequencyBand band{given.lowest, given.highest};
      model.maxwell.mass = maxwell_body(of_mass ? given.block_ratio : 0., band, given.branches);
      model.maxwell.bedrock =
        maxwell_body(of_bedrock ? given.bedrock_ratio : 0., band, given.branches);
      model.maxwell.stiffness.assign(model.blocks.size(), Eigen::Matrix3d::Zero());
      for (std::size_t b = 0; b < model.blocks.size(); ++b)
        {
          const bool bedrock = model.is_bedrock(static_cast<int>(b));
          if (bedrock ? of_bedrock : of_mass)
            model.maxwell.stiffness[b] =
              branch_stiffness(model.blocks[b].elasticity,
                               block_elasticity(materials[b], {}),
                               bedrock ? model.maxwell.bedrock : model.maxwell.mass);
        }
    }



    void Builder::add_slices()
    {
      const Geometry   &g = model.initial;
      std::vector<Vec2> centres;
      for (int b = 0; b < g.n_blocks(); ++b)
        {
          Vec2 sum = Vec2::Zero();
          for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
            sum += g.vertices[v];
          centres.push_back(sum / (g.offset[b + 1] - g.offset[b]));
        }
      model.slice = slices(centres);
    }
  } // namespace



  Model build_model(const SectionMesh       &mesh,
                    const SceneParameters   &scene,
                    const std::vector<Vec2> &foundation_nodes,
                    const BondLaws          &laws)
  {
    return Builder(mesh, scene, foundation_nodes, laws).build();
  }
} // namespace hybrid::dda
