// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/initial_block_stress.h>
#include <hybrid/dda/statics/joint_stretch.h>

namespace hybrid::dda
{
  namespace
  {
    /// The initial stress in the blocks of a model.
    struct BlockStress
    {
      const scene::InitialStress    &initial;
      const int                      mesh_regions;
      const Model                   &model;
      const std::vector<BlockState> &blocks;
      const double                   factor; ///< [-]

      /// At a place in a block or on its outline, (xx, yy, xy) [Pa].
      Eigen::Vector3d at(const int block, const Vec2 &place) const
      {
        const BlockProperties &p      = model.blocks[block];
        const Vec2            &inside = blocks[block].centroid;
        const auto             stress = model.is_bedrock(block)
                                          ? initial.in_bedrock(p.region - mesh_regions, place, inside)
                                          : initial.in_mass(p.region, p.saturated, place, inside);
        return {-factor * stress.horizontal, -factor * stress.vertical, 0.};
      }

      /// What a joint bears at a place of its edge.
      JointTraction traction(const Joint &joint, const Vec2 &place) const
      {
        const Geometry &g = model.initial;
        const Vec2      t = (g.vertices[g.next(joint.edge)] - g.vertices[joint.edge]).normalized();
        const Vec2      n(t.y(), -t.x());
        Eigen::Vector3d stress = at(joint.block, place);
        if (joint.other != foundation_body && joint.kind != JointKind::belt)
          stress = 0.5 * (stress + at(joint.other, place));
        const Vec2 on_other(-stress[0] * n.x() - stress[2] * n.y(),
                            -stress[2] * n.x() - stress[1] * n.y());
        return {on_other.dot(n), on_other.dot(t)};
      }
    };
  } // namespace



  void prescribe_block_stress(const scene::InitialStress &initial,
                              const int                   mesh_regions,
                              const Model                &model,
                              DdaState                   &state,
                              const StressedPart         &part)
  {
    const BlockStress stress{initial, mesh_regions, model, state.blocks, part.factor};
    for (int b = 0; b < model.n_blocks(); ++b)
      if (model.is_bedrock(b) == part.bedrock)
        state.blocks[b].stress = stress.at(b, state.blocks[b].centroid);
    const Geometry &g = model.initial;
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (joint.within_bedrock() != part.bedrock)
          continue;
        const Vec2  a = g.vertices[joint.edge], edge = g.vertices[g.next(joint.edge)] - a;
        JointState &now = state.joints[j];
        for (const int end : {0, 1})
          {
            const double at =
              (2. * joint.points[end].position + joint.points[1 - end].position) / 3.;
            stretch(model, joint, stress.traction(joint, a + at * edge), now.points[end]);
            now.rest_slip[end] = now.points[end].slip;
            now.drawn_gap[end] = now.points[end].gap;
          }
      }
  }
} // namespace hybrid::dda
