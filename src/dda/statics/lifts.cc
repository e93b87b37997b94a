// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/statics/great_static_steps.h>
#include <hybrid/dda/statics/joint_stretch.h>
#include <hybrid/dda/statics/lifts.h>
#include <hybrid/dda/statics/static_steps.h>
#include <hybrid/dda/step/initial_state.h>
#include <hybrid/dda/step/rest_forces.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace hybrid::dda
{
  namespace
  {
    /// For each block of the mass the lift that its centroid is in, from 0 at the bottom.
    std::vector<int> lifts_by_height(const Model &model, const DdaState &state, const int lifts)
    {
      const auto &vertices = model.initial.vertices;
      const auto  end      = vertices.begin() + model.initial.offset[model.n_mass()];
      const auto [low, high] =
        std::minmax_element(vertices.begin(), end, [](const Vec2 &a, const Vec2 &b) {
          return a.y() < b.y();
        });
      std::vector<int> of_block;
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const double part = (state.blocks[b].centroid.y() - low->y()) / (high->y() - low->y());
          of_block.push_back(std::clamp(static_cast<int>(lifts * part), 0, lifts - 1));
        }
      return of_block;
    }



    /// A mass that grows, as linear elasticity of the section as drawn.
    class GrowingMass
    {
    public:
      explicit GrowingMass(const Model &whole)
        : model(whole)
        , elastic(with_unlimited_bonds(model))
        , drawn(initial_state(model))
        , placed(model.n_mass(), 0)
        , stress(model.n_mass(), Eigen::Vector3d::Zero())
        , moved(model.n_mass(), Vec2::Zero())
        , tractions(model.joints.size())
      {
        all_joints.swap(elastic.joints);
        elastic.hold_bedrock = true;
      }

      /// Blocks and joints as drawn.
      const DdaState &state() const
      {
        return drawn;
      }

      /// Place those of the @p present blocks that joints hold, by way of others, to the ground,
      /// and let their weight act. @return whether there is a new one
      bool grow(const std::vector<char> &present)
      {
        const std::vector<char> held = held_to_ground(model, present);
        std::vector<int>        added;
        for (int b = 0; b < model.n_mass(); ++b)
          if (held[b] && !placed[b])
            added.push_back(b);
        for (const int b : added)
          placed[b] = 1;
        if (!added.empty())
          load(added);
        return !added.empty();
      }

      /// Give the mass stresses and tractions.
      void store(DdaState &state) const;

      /// Find the block that has moved farthest since it was placed.
      void find_largest(LiftResult &result) const;

    private:
      using Ends = std::array<JointTraction, 2>;

      const Model                 &model;
      Model                        elastic;    ///< joints: those between placed bodies
      std::vector<Joint>           all_joints; ///< with unlimited bonds
      const DdaState               drawn;
      std::vector<char>            placed; ///< per block of the mass
      std::vector<Eigen::Vector3d> stress; ///< likewise (xx, yy, xy) [Pa]
      std::vector<Vec2>            moved;  ///< likewise, the centroid since it was placed [m]
      std::vector<Ends>            tractions;

      bool is_there(const int body) const
      {
        return body == foundation_body || elastic.is_bedrock(body) || placed[body];
      }

      /// Weight and water of a block [N/m, N].
      Vec6 load_of(int block) const;

      /// Stiffness of what is placed; the other blocks have no coupling.
      BlockMatrix assemble(Springs               &springs,
                           const SpringStiffness &stiffness,
                           const DdaState        &state,
                           const Trial           &trial) const;

      /// Find and add the response to the loads of blocks.
      void load(const std::vector<int> &added);
    };



    Vec6 GrowingMass::load_of(const int block) const
    {
      const BlockProperties &p     = elastic.blocks[block];
      Vec6                   force = Vec6::Zero();
      force[1]                     = -p.weight * elastic.gravity;
      if (elastic.water.action == Water::Action::none)
        return force;
      const Geometry &g     = drawn.geometry;
      const int       first = g.offset[block];
      return force + water_load(elastic.water,
                                p.area,
                                BlockMotion(drawn.blocks[block].centroid, Vec6::Zero()),
                                {&g.vertices[first], nullptr, g.offset[block + 1] - first})
                       .force;
    }



    BlockMatrix GrowingMass::assemble(Springs               &springs,
                                      const SpringStiffness &stiffness,
                                      const DdaState        &state,
                                      const Trial           &trial) const
    {
      BlockMatrix matrix;
      springs.connect(elastic, matrix);
      matrix.set_zero();
      for (int b = 0; b < elastic.n_blocks(); ++b)
        if (elastic.is_bedrock(b) || !placed[b])
          matrix.diagonal[b].setIdentity();
        else
          {
            const BlockProperties &p = elastic.blocks[b];
            matrix.diagonal[b].bottomRightCorner<3, 3>() += p.area * p.elasticity;
            stiffness.add_rows(springs, b, matrix);
          }
      add_bedrock_stiffness({elastic, state, trial, Eigen::VectorXd()}, {}, matrix);
      return matrix;
    }



    void GrowingMass::load(const std::vector<int> &added)
    {
      std::vector<std::size_t> number; // of each joint between placed bodies
      elastic.joints.clear();
      for (std::size_t j = 0; j < all_joints.size(); ++j)
        if (!all_joints[j].within_bedrock() && is_there(all_joints[j].block) &&
            is_there(all_joints[j].other))
          {
            number.push_back(j);
            elastic.joints.push_back(all_joints[j]);
          }
      DdaState start = drawn;
      start.joints.assign(number.size(), {});
      const Trial     trial   = trial_at_rest(start);
      Springs         springs = springs_at_rest(elastic, start);
      SpringStiffness stiffness;
      stiffness.update(springs, trial, {});
      const BlockMatrix matrix = assemble(springs, stiffness, start, trial);

      Eigen::VectorXd force = Eigen::VectorXd::Zero(matrix.size()), u = force;
      for (const int b : added)
        force.segment<6>(6 * b) = load_of(b);
      SparseFactor factor;
      factor.factorize(matrix);
      factor.solve(force, u);

      for (int b = 0; b < elastic.n_mass(); ++b)
        {
          stress[b] += elastic.blocks[b].elasticity * u.segment<3>(6 * b + 3);
          moved[b] += u.segment<2>(6 * b);
        }
      for (std::size_t s = 0; s < springs.springs.size(); ++s)
        {
          const Springs::Spring &spring   = springs.springs[s];
          const Vec2             jump     = stiffness.displacement_jump(springs, s, u);
          JointTraction         &traction = tractions[number[spring.joint]][spring.end];
          traction.normal -= spring.law->normal_stiffness() * jump.x();
          traction.shear -= spring.law->shear_stiffness() * jump.y();
        }
    }



    void GrowingMass::store(DdaState &state) const
    {
      for (int b = 0; b < model.n_mass(); ++b)
        state.blocks[b].stress = stress[b];
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        for (int end = 0; end < 2 && !model.joints[j].within_bedrock(); ++end)
          {
            JointState &now = state.joints[j];
            stretch(model, model.joints[j], tractions[j][end], now.points[end]);
            now.rest_slip[end] = now.points[end].slip;
            now.drawn_gap[end] = now.points[end].gap;
          }
    }



    void GrowingMass::find_largest(LiftResult &result) const
    {
      for (std::size_t b = 0; b < moved.size(); ++b)
        if (moved[b].norm() > result.largest_displacement)
          {
            result.largest_displacement = moved[b].norm();
            result.place                = drawn.blocks[b].centroid;
          }
    }
  } // namespace



  LiftResult place_in_lifts(const Model &model, const int lifts, DdaState &state)
  {
    LiftResult             result;
    GrowingMass            mass(model);
    const std::vector<int> lift_of = lifts_by_height(model, mass.state(), lifts);
    for (int lift = 0; lift < lifts; ++lift)
      {
        std::vector<char> present;
        for (const int of_block : lift_of)
          present.push_back(of_block <= lift ? 1 : 0);
        result.lifts += mass.grow(present) ? 1 : 0;
      }
    mass.store(state);
    mass.find_largest(result);
    return result;
  }



  void check_lifts(const Model &model)
  {
    const std::vector<char> held = held_to_ground(model, std::vector<char>(model.n_mass(), 1));
    const auto              free = std::find(held.begin(), held.end(), 0);
    if (free == held.end())
      return;
    const int          block = static_cast<int>(free - held.begin());
    const Vec2         place = initial_state(model).blocks[block].centroid;
    std::ostringstream text;
    text << "Gravity/Initial stress = staged needs a mass that joints hold to the ground; none "
            "holds block "
         << block << " at (" << place.x() << ", " << place.y()
         << ") m, directly or by way of others. A belt bonds edges of a mesh that lie on its "
            "sliding_surface.";
    throw InputError(text.str());
  }
} // namespace hybrid::dda
