// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/tan_degrees.h>
#include <hybrid/dda/model/model_builder.h>
#include <hybrid/dda/statics/begin_motion.h>
#include <hybrid/dda/statics/initial_bedding_tractions.h>
#include <hybrid/dda/statics/initial_block_stress.h>
#include <hybrid/dda/statics/joint_stretch.h>
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/block_energy.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/dda/step/rest_forces.h>
#include <hybrid/dda/step/start_accelerations.h>
#include <hybrid/scene/bedrock/triangles_bedrock.h>
#include <hybrid/scene/boundary/fixed_base.h>
#include <hybrid/scene/first_of_largest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace hybrid::dda
{
  namespace
  {
    using scene::SceneParameters;
    using scene::SectionMesh;

    constexpr double     load_fraction = 1e-3; ///< of loads and strengths in the model at rest
    constexpr StaticPace pace{4., 200};



    using Ends = std::pair<double, double>;

    /// An end of a joint: its place, and that of the other end [m].
    using EndKey = std::pair<Ends, Ends>;

    EndKey key_of(const Model &model, const Joint &joint, const int end)
    {
      const Geometry &g = model.initial;
      const Vec2      a = g.vertices[joint.edge], b = g.vertices[g.next(joint.edge)];
      const Ends      first{a.x(), a.y()}, second{b.x(), b.y()};
      return end == 0 ? EndKey{first, second} : EndKey{second, first};
    }



    /// The bedrock alone, in triangles on a fixed base, with a part of its strengths.
    SceneParameters scene_at_rest(SceneParameters scene)
    {
      scene.bedrock        = scene::triangles_bedrock();
      scene.continuum.base = scene::fixed_base();
      scene.blocks.enabled = false;
      scene.edge_loads.tractions.clear();
      scene.bedding.cohesion *= load_fraction;
      scene.bedding.tensile_strength *= load_fraction;
      scene.bedding.initial_normal_stress *= load_fraction;
      return scene;
    }



    /// The model at rest: what carries the bedrock, and what it bears.
    class RestModel
    {
    public:
      RestModel(const SectionMesh &section, const SceneParameters &parameters)
        : mesh(section)
        , scene(scene_at_rest(parameters))
        , blocks(cut_bedrock(mesh, scene))
      {
        std::vector<Vec2> nodes;
        for (const int node : blocks.foundation)
          nodes.push_back(mesh.nodes[node]);
        model = static_problem(build_model(mesh, scene, nodes));
        for (const BoundaryEdge &edge : model.boundary)
          add_roller(edge);
        model.boundary.clear();
        state = initial_state(model);
        for (std::size_t j = 0; j < model.joints.size(); ++j)
          if (model.joints[j].kind == JointKind::bedding)
            for (SpringState &point : state.joints[j].points)
              stretch(model, model.joints[j], {scene.bedding.initial_normal_stress}, point);
        store_static_reactions(model, state, {});
      }

      void load_weight()
      {
        for (BlockProperties &block : model.blocks)
          {
            block.weight      = load_fraction * block.weight_at_rest;
            block.pushed_mass = load_fraction * block.mass;
          }
      }

      /// Pore pressure in rock and planes, and the water above the rock: together they are buoyancy
      /// and seepage force of the rock, whose joints bear effective stress (see water_load()).
      void load_water(const Water &water);

      /// Stress that the bedrock has from the start, of the section with its mass.
      void prescribe_stress(const scene::InitialStress &initial);

      /// What the mass of another model puts on the bedrock.
      void load_mass(const Model &other, const DdaState &settled);

      /// @return true at rest
      bool settle()
      {
        return take_static_steps(model, state, pace).equilibrium;
      }

      /// Tractions of the planes, and what they do.
      std::map<EndKey, JointTraction> tractions(BeddingRest &result) const;

      /// Where elastic planes bear most shear beyond the strength of the scene's planes.
      void find_most_loaded(const scene::BeddingParameters &strength, BeddingRest &result) const;

    private:
      const SectionMesh         &mesh;
      const SceneParameters      scene;
      const scene::BedrockBlocks blocks;
      Model                      model;
      DdaState                   state;

      /// Edge of a triangle on the surface, counter-clockwise [m].
      struct SurfaceEdge
      {
        int  block;
        Vec2 from, to;
      };

      std::vector<SurfaceEdge> surface_edges() const;

      void add_roller(const BoundaryEdge &edge);

      /// A part of a force [N/m] on a triangle.
      void load(int block, const Vec2 &place, const Vec2 &force);
    };



    /// Lets an edge slide along the side of the model.
    void RestModel::add_roller(const BoundaryEdge &edge)
    {
      const double k    = model.contacts.of.front()[edge.block].law.normal_stiffness();
      const int    node = model.n_foundation_nodes();
      model.joints.push_back({edge.block,
                              edge.vertex,
                              foundation_body,
                              (edge.ends[1] - edge.ends[0]).norm(),
                              {{0., node}, {1., node + 1}},
                              JointLaw(JointStrength::roller(), k, k),
                              1.,
                              JointKind::weld});
      model.initial.foundation_nodes.insert(model.initial.foundation_nodes.end(),
                                            {edge.ends[0], edge.ends[1]});
    }



    std::vector<RestModel::SurfaceEdge> RestModel::surface_edges() const
    {
      std::set<std::pair<int, int>> surface;
      for (const char *name : {"sliding_surface", "ground"})
        if (const auto line = mesh.lines.find(name); line != mesh.lines.end())
          for (const auto &edge : line->second)
            surface.insert(std::minmax(edge[0], edge[1]));
      std::vector<SurfaceEdge> edges;
      for (std::size_t b = 0; b < blocks.outlines.size(); ++b)
        for (std::size_t k = 0; k < 3; ++k)
          {
            const int from = blocks.outlines[b][k], to = blocks.outlines[b][(k + 1) % 3];
            if (surface.count(std::minmax(from, to)) > 0)
              edges.push_back({static_cast<int>(b), mesh.nodes[from], mesh.nodes[to]});
          }
      return edges;
    }



    void RestModel::load(const int block, const Vec2 &place, const Vec2 &force)
    {
      const BlockMotion at_rest(state.blocks[block].centroid, Vec6::Zero());
      state.bedrock_static_force.segment<6>(6 * block) -=
        at_rest.gradient(place, load_fraction * force);
    }



    void RestModel::load_water(const Water &water)
    {
      Water buoyant  = water;
      buoyant.action = Water::Action::buoyancy;
      for (int b = 0; b < model.n_blocks(); ++b)
        {
          const Geometry    &g = model.initial;
          const int          n = g.offset[b + 1] - g.offset[b];
          const MovedOutline outline{&g.vertices[g.offset[b]], nullptr, n};
          const BlockMotion  at_rest(state.blocks[b].centroid, Vec6::Zero());
          state.bedrock_static_force.segment<6>(6 * b) -=
            load_fraction * water_load(buoyant, model.blocks[b].area, at_rest, outline).force;
        }
    }



    void RestModel::prescribe_stress(const scene::InitialStress &initial)
    {
      prescribe_block_stress(initial,
                             static_cast<int>(mesh.block_region_names.size()),
                             model,
                             state,
                             {true, load_fraction});
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        if (model.joints[j].kind == JointKind::bedding)
          for (SpringState &point : state.joints[j].points)
            stretch(model,
                    model.joints[j],
                    {point.normal + scene.bedding.initial_normal_stress, point.shear},
                    point);
    }



    void RestModel::load_mass(const Model &other, const DdaState &settled)
    {
      const std::vector<SurfaceEdge> edges   = surface_edges();
      const auto                     is_mass = [&](const int body) {
        return body != foundation_body && body < other.n_mass();
      };
      const Springs springs = springs_at_rest(other, settled);
      for (std::size_t s = 0; s < springs.springs.size() && !edges.empty(); ++s)
        {
          const Springs::Spring   &spring = springs.springs[s];
          const Springs::Response &r      = springs.responses[s];
          if (is_mass(spring.block) == is_mass(spring.other))
            continue;
          const double sign = is_mass(spring.block) ? 1. : -1.; // the force acts on the other
          const Vec2   force =
            sign * spring.length * (r.now.normal * r.normal + r.now.shear * r.tangent);
          const auto distance = [&](const SurfaceEdge &edge) {
            return (0.5 * (edge.from + edge.to) - r.place).squaredNorm();
          };
          const auto nearest =
            std::min_element(edges.begin(), edges.end(), [&](const auto &e, const auto &f) {
              return distance(e) < distance(f);
            });
          load(nearest->block, 0.5 * (nearest->from + nearest->to), force);
        }
    }



    std::map<EndKey, JointTraction> RestModel::tractions(BeddingRest &result) const
    {
      std::map<EndKey, JointTraction> found;
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (int end = 0; end < 2 && model.joints[j].kind == JointKind::bedding; ++end)
          {
            const SpringState &point = state.joints[j].points[end];
            const EndKey       key   = key_of(model, model.joints[j], end);
            found[key]               = {point.elastic_normal / load_fraction,
                                        point.elastic_shear / load_fraction,
                                        point.history.damage >= 1.};
            const bool   open        = point.state == ContactState::open;
            const double slip        = std::abs(point.history.plastic_slip) / load_fraction;
            result.slipping += point.state == ContactState::sliding;
            result.open += open;
            if (!open && slip > result.largest)
              {
                result.largest = slip;
                result.where   = Vec2(key.first.first, key.first.second);
                result.plane   = model.joints[j].plane;
              }
          }
      return found;
    }



    void RestModel::find_most_loaded(const scene::BeddingParameters &strength,
                                     BeddingRest                    &result) const
    {
      const double                      friction = tan_degrees(strength.friction_angle);
      std::vector<double>               excess;
      std::vector<std::pair<Vec2, int>> ends; // place, plane
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (int end = 0; end < 2 && model.joints[j].kind == JointKind::bedding; ++end)
          {
            const SpringState &point = state.joints[j].points[end];
            const Ends         place = key_of(model, model.joints[j], end).first;
            excess.push_back((std::abs(point.elastic_shear) - friction * point.elastic_normal) /
                               load_fraction -
                             strength.cohesion);
            ends.emplace_back(Vec2(place.first, place.second), model.joints[j].plane);
          }
      if (!excess.empty())
        std::tie(result.where, result.plane) = ends[first_of_largest(excess)];
    }
  } // namespace



  BeddingRest stress_bedding_planes(const SectionMesh     &mesh,
                                    const SceneParameters &scene,
                                    const Model           &model,
                                    const bool             under_gravity,
                                    DdaState              &state)
  {
    BeddingRest result;
    RestModel   rest(mesh, scene);
    const bool  held = under_gravity && scene.environment.static_stage == scene::StaticStage::held;
    const auto  settle = [&](RestModel &loaded) {
      if (scene.environment.has_initial_stress())
        loaded.prescribe_stress(scene::InitialStress(mesh, scene));
      loaded.load_weight();
      if (model.water.action != Water::Action::none)
        loaded.load_water(model.water);
      loaded.load_mass(held ? with_unlimited_strengths(model) : model, state);
      return loaded.settle();
    };
    if (under_gravity)
      result.equilibrium = settle(rest);
    std::map<EndKey, JointTraction> tractions = rest.tractions(result);
    if (!result.equilibrium) // what they hold slides from the first step on
      {
        SceneParameters elastic = scene;
        elastic.bedding.slips   = false;
        RestModel intact(mesh, elastic);
        settle(intact);
        BeddingRest none;
        tractions = intact.tractions(none);
        intact.find_most_loaded(scene.bedding, result);
      }
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      for (int end = 0; end < 2 && model.joints[j].kind == JointKind::bedding; ++end)
        {
          const Joint &joint = model.joints[j];
          stretch(model,
                  joint,
                  tractions.at(key_of(model, joint, end)),
                  state.joints[j].points[end]);
        }
    store_static_reactions(model, state, {held, !result.equilibrium});
    state.energy = stored_energy(model, state);
    return result;
  }
} // namespace hybrid::dda
