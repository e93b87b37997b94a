// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>
#include <hybrid/dda/model/block_materials.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /// The bodies between which joints are made.
  struct JointedBlocks
  {
    const std::vector<std::vector<int>> &outlines;  ///< nodes of the mesh; mass, then bedrock
    const std::vector<Material>         &materials; ///< of each block, with its modulus
    int                                  n_mass;    ///< blocks of the sliding mass
  };


  /**
   * Finds the edges that blocks share with each other or with the foundation and
   * bonds them:
   *   - body: within the sliding mass, artificial joints (unless it is loose);
   *   - belt: on the line "sliding_surface", between mass and bedrock or foundation;
   *   - bedding: on a bedding plane of the scene, with its stiffness per area;
   *   - weld: within the bedrock elsewhere, artificial joints that never fail.
   */
  class JointBuilder
  {
  public:
    /// All must outlive the builder; joints go to @p model, which has its blocks already.
    JointBuilder(const scene::SectionMesh     &mesh,
                 const scene::SceneParameters &scene,
                 const BondLaws               &laws,
                 const JointedBlocks          &blocks,
                 Model                        &model);

    /// Between blocks, and the joint lines of the mass.
    void add_block_joints();

    /// Between the sliding mass and the foundation. @throws InputError if the two do not fit.
    void add_belt_joints();

    /// Between blocks of the bedrock and the foundation.
    void add_foundation_joints();

  private:
    /// An edge of a block: its first vertex and its nodes in the mesh.
    struct EdgeOfBlock
    {
      int block, vertex, from, to;
    };

    using Pair = std::pair<int, int>;

    const scene::SectionMesh     &mesh;
    const scene::SceneParameters &scene;
    const BondLaws               &laws;
    const JointedBlocks          &blocks;
    const BlockMaterials          material;
    Model                        &model;
    std::map<Pair, int> bedding; ///< edges on planes of the scene, nodes ascending -> plane
    std::map<std::pair<double, double>, int> foundation_at; ///< place [m] -> foundation node
    std::map<Pair, double> shared; ///< welded or bedding length between two bodies [m]

    EdgeOfBlock edge_of(std::size_t block, std::size_t k) const;

    /// Foundation node at a node of the mesh, or -1.
    int foundation_node(int node) const;

    void measure_shared_lengths();

    /// @param ends of the joint [m]
    void
    add_bond(Joint joint, const Material &strength, double height, const std::array<Vec2, 2> &ends);

    void add_pair(const EdgeOfBlock &first, const EdgeOfBlock &second);

    /// To the line of the mesh that an edge between two blocks of the mass is on, if there is one.
    void add_to_line(const EdgeOfBlock &first, const EdgeOfBlock &second);

    void add_bedrock_joint(Joint joint, const EdgeOfBlock &edge);

    double softer_modulus(int block, int other) const;

    /// Time that a P wave takes through the height of a joint's blocks, the slower one's [s].
    double crossing_time(int block, int other, double height) const;
  };
} // namespace hybrid::dda
