// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/joint/bedding_strength.h>
#include <hybrid/dda/model/joint_builder.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hybrid::dda
{
  JointBuilder::JointBuilder(const scene::SectionMesh     &section,
                             const scene::SceneParameters &parameters,
                             const BondLaws               &chosen_laws,
                             const JointedBlocks          &jointed_blocks,
                             Model                        &block_model)
    : mesh(section)
    , scene(parameters)
    , laws(chosen_laws)
    , blocks(jointed_blocks)
    , material(section, parameters)
    , model(block_model)
  {
    const Geometry &g = model.initial;
    for (std::size_t k = 0; k < g.foundation_nodes.size(); ++k)
      foundation_at[{g.foundation_nodes[k].x(), g.foundation_nodes[k].y()}] = static_cast<int>(k);
    if (model.n_bedrock == 0)
      return;
    for (std::size_t plane = 0; plane < scene.bedding.names.size(); ++plane)
      for (const auto &edge : mesh.lines.at(scene.bedding.names[plane]))
        bedding[{std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}] = static_cast<int>(plane);
    measure_shared_lengths();
  }



  JointBuilder::EdgeOfBlock JointBuilder::edge_of(const std::size_t b, const std::size_t k) const
  {
    const auto &nodes = blocks.outlines[b];
    return {static_cast<int>(b),
            model.initial.offset[b] + static_cast<int>(k),
            nodes[k],
            nodes[(k + 1) % nodes.size()]};
  }



  int JointBuilder::foundation_node(const int node) const
  {
    const auto found = foundation_at.find({mesh.nodes[node].x(), mesh.nodes[node].y()});
    return found == foundation_at.end() ? -1 : found->second;
  }



  void JointBuilder::measure_shared_lengths()
  {
    std::map<Pair, int> open_edges;
    for (std::size_t b = blocks.n_mass; b < blocks.outlines.size(); ++b)
      for (std::size_t k = 0; k < blocks.outlines[b].size(); ++k)
        {
          const EdgeOfBlock e      = edge_of(b, k);
          const double      length = (mesh.nodes[e.to] - mesh.nodes[e.from]).norm();
          const auto        twin   = open_edges.find({e.to, e.from});
          const int         start = foundation_node(e.from), end = foundation_node(e.to);
          if (twin != open_edges.end())
            shared[{twin->second, e.block}] += length;
          else if (start >= 0 && end == start + 1)
            shared[{foundation_body, e.block}] += length;
          else
            open_edges[{e.from, e.to}] = e.block;
        }
  }



  double JointBuilder::softer_modulus(const int block, const int other) const
  {
    const double e = blocks.materials[block].young_modulus;
    return other == foundation_body ? e : std::min(e, blocks.materials[other].young_modulus);
  }



  double JointBuilder::crossing_time(const int block, const int other, const double height) const
  {
    const auto time = [&](const int b) {
      const Material &m = blocks.materials[b];
      return height * std::sqrt(m.density / (m.lame_lambda() + 2. * m.shear_modulus()));
    };
    return other == foundation_body ? time(block) : std::max(time(block), time(other));
  }



  void JointBuilder::add_bond(Joint                      joint,
                              const Material            &strength,
                              const double               height,
                              const std::array<Vec2, 2> &ends)
  {
    const bool   belt = joint.kind == JointKind::belt;
    const double k_n  = scene.blocks.penalty_ratio *
                       softer_modulus(joint.block, belt ? foundation_body : joint.other) / height;
    joint.strength_factor = material.factor(scene.heterogeneity.strength_shape,
                                            belt ? BlockMaterials::belt_strength_number
                                                 : BlockMaterials::body_strength_number,
                                            {ends.begin(), ends.end()});
    Material m            = strength;
    m.cohesion *= joint.strength_factor;
    m.residual_cohesion *= joint.strength_factor;
    m.tensile_strength *= joint.strength_factor;
    const double fracture_energy = scene.blocks.fracture_energy;
    const double softening_slip  = scene.blocks.softening_slip;
    joint.law =
      JointLaw((belt ? laws.belt : laws.body).bond(m, fracture_energy, softening_slip),
               k_n,
               scene.blocks.shear_ratio * k_n)
        .letting_go_in(crossing_time(joint.block, belt ? foundation_body : joint.other, height));
    model.joints.push_back(joint);
    model.bonded[joint.block] = true;
    if (joint.other != foundation_body)
      model.bonded[joint.other] = true;
  }



  void JointBuilder::add_bedrock_joint(Joint joint, const EdgeOfBlock &edge)
  {
    const Pair nodes{std::min(edge.from, edge.to), std::max(edge.from, edge.to)};
    double     k_n = scene.bedding.normal_stiffness, k_s = scene.bedding.shear_stiffness;
    const auto plane = bedding.find(nodes);
    joint.kind       = plane != bedding.end() ? JointKind::bedding : JointKind::weld;
    if (joint.kind == JointKind::bedding)
      joint.plane = plane->second;
    else
      {
        const double area   = joint.other == foundation_body
                                ? 2. * model.blocks[joint.block].area
                                : model.blocks[joint.block].area + model.blocks[joint.other].area;
        const Pair   bodies = joint.other == foundation_body ? Pair{foundation_body, joint.block}
                                                             : Pair{joint.block, joint.other};
        k_n = scene.blocks.penalty_ratio * softer_modulus(joint.block, joint.other) *
              shared.at(bodies) / area;
        k_s = scene.blocks.shear_ratio * k_n;
      }
    joint.law = JointLaw(joint.kind == JointKind::bedding ? bedding_strength(scene.bedding)
                                                          : JointStrength::unlimited_bond(),
                         k_n,
                         k_s);
    model.joints.push_back(joint);
    model.bonded[joint.block] = true;
    if (joint.other != foundation_body)
      model.bonded[joint.other] = true;
  }



  void JointBuilder::add_to_line(const EdgeOfBlock &first, const EdgeOfBlock &second)
  {
    const std::string *name = material.joint_line(first.from, first.to);
    if (name == nullptr)
      return;
    const auto at     = std::lower_bound(model.joint_lines.begin(),
                                     model.joint_lines.end(),
                                     *name,
                                     [](const JointLine &line, const std::string &other) {
                                       return line.name < other;
                                     });
    const bool is_new = at == model.joint_lines.end() || at->name != *name;
    const auto line   = is_new ? model.joint_lines.insert(at, {*name, {}}) : at;
    line->edges.push_back({first.vertex, second.vertex});
  }



  void JointBuilder::add_pair(const EdgeOfBlock &first, const EdgeOfBlock &second)
  {
    const Geometry &g = model.initial;
    const Vec2      a = g.vertices[first.vertex], e = g.vertices[g.next(first.vertex)];
    const double    length = (e - a).norm();
    Joint           joint{first.block,
                first.vertex,
                second.block,
                length,
                {{0., g.next(second.vertex)}, {1., second.vertex}},
                {{}, 1., 1.}};
    const bool      saturated = material.below_water(0.5 * (a + e));
    if (first.block >= blocks.n_mass)
      add_bedrock_joint(joint, first);
    else if (second.block >= blocks.n_mass)
      {
        joint.kind = JointKind::belt;
        if (!scene.blocks.belt_material.empty())
          add_bond(joint,
                   material.belt(saturated),
                   2. * model.blocks[first.block].area / length,
                   {a, e});
      }
    else
      {
        add_to_line(first, second);
        if (!scene.blocks.bonded)
          return;
        const BlockProperties &p = model.blocks[first.block], &q = model.blocks[second.block];
        const Material        *of_line = material.joint(first.from, first.to, saturated);
        add_bond(joint,
                 of_line != nullptr ? *of_line : material.bond(p.region, q.region, saturated),
                 (p.area + q.area) / length,
                 {a, e});
      }
  }



  void JointBuilder::add_block_joints()
  {
    std::map<Pair, EdgeOfBlock> open_edges; // (first node, second node)
    for (std::size_t b = 0; b < blocks.outlines.size(); ++b)
      for (std::size_t k = 0; k < blocks.outlines[b].size(); ++k)
        {
          const EdgeOfBlock edge = edge_of(b, k);
          const auto        twin = open_edges.find({edge.to, edge.from});
          if (twin == open_edges.end())
            {
              open_edges[{edge.from, edge.to}] = edge;
              continue;
            }
          add_pair(twin->second, edge);
          open_edges.erase(twin);
        }
  }



  void JointBuilder::add_foundation_joints()
  {
    const Geometry &g = model.initial;
    for (std::size_t b = blocks.n_mass; b < blocks.outlines.size(); ++b)
      for (std::size_t k = 0; k < blocks.outlines[b].size(); ++k)
        {
          const EdgeOfBlock edge  = edge_of(b, k);
          const int         start = foundation_node(edge.from), end = foundation_node(edge.to);
          if (start < 0 || end != start + 1)
            continue;
          const double length = (g.foundation_nodes[end] - g.foundation_nodes[start]).norm();
          add_bedrock_joint({edge.block,
                             edge.vertex,
                             foundation_body,
                             length,
                             {{0., start}, {1., end}},
                             {{}, 1., 1.}},
                            edge);
        }
  }



  void JointBuilder::add_belt_joints()
  {
    const auto line = mesh.lines.find("sliding_surface");
    if (line == mesh.lines.end() || scene.blocks.belt_material.empty() ||
        model.initial.foundation_nodes.size() < 2)
      return;
    const Geometry &g = model.initial;
    std::set<Pair>  on_surface;
    for (const auto &edge : line->second)
      on_surface.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});

    for (int b = 0; b < blocks.n_mass; ++b)
      for (std::size_t k = 0; k < blocks.outlines[b].size(); ++k)
        {
          const EdgeOfBlock edge = edge_of(b, k);
          if (on_surface.count({std::min(edge.from, edge.to), std::max(edge.from, edge.to)}) == 0)
            continue;
          const Vec2 a = mesh.nodes[edge.from], e = mesh.nodes[edge.to];
          const int  start = foundation_node(edge.from), end = foundation_node(edge.to);
          if (start < 0 || end < 0 || start >= end)
            {
              if (model.n_bedrock > 0)
                continue; // that edge lies on a block of the bedrock
              throw InputError(
                "the mesh's line 'sliding_surface' and the bedrock's surface do not share "
                "the node at (" +
                std::to_string(a.x()) + ", " + std::to_string(a.y()) +
                "): blocks must lie above the bedrock and share its edges");
            }
          const double length = (e - a).norm();
          for (int node = start; node < end; ++node)
            {
              const Vec2   p = g.foundation_nodes[node], q = g.foundation_nodes[node + 1];
              const double from_a = (p - a).norm() / length, to_a = (q - a).norm() / length;
              add_bond({b,
                        edge.vertex,
                        foundation_body,
                        (q - p).norm(),
                        {{from_a, node}, {to_a, node + 1}},
                        {{}, 1., 1.},
                        1.,
                        JointKind::belt},
                       material.belt(material.below_water(0.5 * (p + q))),
                       2. * model.blocks[b].area / length,
                       {p, q});
            }
        }
  }
} // namespace hybrid::dda
