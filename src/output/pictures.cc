// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block_motion.h>
#include <hybrid/output/pictures.h>
#include <hybrid/restart/archive.h>

namespace hybrid::output
{
  Pictures::Pictures(const std::string          &directory,
                     const dda::Model           *blocks,
                     const continuum::Continuum *continuum)
    : model(blocks)
  {
    if (model != nullptr)
      {
        block_series = std::make_unique<PvdSeries>(directory, "blocks");
        joint_series = std::make_unique<PvdSeries>(directory, "joints");
        reference    = model->initial;
        for (const dda::BlockProperties &block : model->blocks)
          varied_modulus = varied_modulus || block.modulus_factor != 1.;
        for (const dda::Joint &joint : model->joints)
          varied_strength = varied_strength || joint.strength_factor != 1.;
      }
    if (continuum != nullptr)
      {
        bedrock.emplace(*continuum);
        continuum_series = std::make_unique<PvdSeries>(directory, "continuum");
      }
  }



  void Pictures::set_reference(const dda::DdaState &state)
  {
    reference = state.geometry;
  }



  void Pictures::add(const coupling::CoupledState &state)
  {
    if (model != nullptr)
      {
        add_blocks(state);
        add_joints(state);
      }
    if (bedrock)
      continuum_series->add(state.time, [&](const std::string &file_name) {
        bedrock->write(state.continuum, file_name);
      });
    writer = VtuWriter(); // rarely used: its memory is others' in between
  }



  void Pictures::serialize(restart::Archive &archive)
  {
    archive(reference);
    for (PvdSeries *series : {block_series.get(), joint_series.get(), continuum_series.get()})
      if (series != nullptr)
        archive(*series);
  }



  std::vector<std::string> Pictures::missing_files() const
  {
    std::vector<std::string> files;
    for (const PvdSeries *series : {block_series.get(), joint_series.get(), continuum_series.get()})
      if (series != nullptr)
        for (const std::string &file : series->missing_files())
          files.push_back(file);
    return files;
  }



  void Pictures::add_blocks(const coupling::CoupledState &state)
  {
    const dda::Geometry &g = state.blocks.geometry;
    writer.clear();
    std::vector<double> displacement, velocity, stress, rotation, region;
    std::vector<int>    nodes;
    for (int b = 0; b < g.n_blocks(); ++b)
      {
        const dda::BlockState &block = state.blocks.blocks[b];
        const dda::BlockMotion at_rest(block.centroid, dda::Vec6::Zero());
        nodes.clear();
        for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
          {
            nodes.push_back(writer.add_point(g.vertices[v]));
            const Vec2 u = g.vertices[v] - reference.vertices[v];
            displacement.insert(displacement.end(), {u.x(), u.y()});
            velocity.push_back(at_rest.gradient(g.vertices[v], Vec2::UnitX()).dot(block.velocity));
            velocity.push_back(at_rest.gradient(g.vertices[v], Vec2::UnitY()).dot(block.velocity));
          }
        writer.add_cell(nodes.size() == 3 ? CellShape::triangle : CellShape::polygon, nodes);
        stress.insert(stress.end(), block.stress.data(), block.stress.data() + 3);
        rotation.push_back(block.rotation);
        region.push_back(model->blocks[b].region);
      }
    writer.add_point_field("displacement [m]", {"x", "y"}, std::move(displacement));
    writer.add_point_field("velocity [m/s]", {"x", "y"}, std::move(velocity));
    writer.add_cell_field("stress xx, yy, xy [Pa]", {"xx", "yy", "xy"}, std::move(stress));
    writer.add_cell_field("rotation [rad]", std::move(rotation));
    writer.add_cell_field("region", std::move(region));
    if (varied_modulus)
      {
        std::vector<double> factor;
        for (const dda::BlockProperties &block : model->blocks)
          factor.push_back(block.modulus_factor);
        writer.add_cell_field("modulus factor", std::move(factor));
      }
    if (model->blocks_yield)
      {
        std::vector<double> total, at_rest;
        for (const dda::BlockState &block : state.blocks.blocks)
          {
            total.push_back(block.plastic_strain - block.rest_plastic_strain);
            at_rest.push_back(block.rest_plastic_strain);
          }
        writer.add_cell_field("plastic shear strain", std::move(total));
        writer.add_cell_field("plastic shear strain at rest", std::move(at_rest));
      }
    block_series->add(state.time, writer);
  }



  void Pictures::add_joints(const coupling::CoupledState &state)
  {
    const dda::Geometry &g = state.blocks.geometry;
    writer.clear();
    std::vector<double> displacement, failure, time, opening, slip, normal, shear;
    for (std::size_t j = 0; j < model->joints.size(); ++j)
      {
        const dda::Joint      &joint = model->joints[j];
        const dda::JointState &s     = state.blocks.joints[j];
        const auto             end   = [&](const dda::Geometry &at, const int k) -> Vec2 {
          const Vec2 &a = at.vertices[joint.edge], &b = at.vertices[g.next(joint.edge)];
          return a + joint.points[k].position * (b - a);
        };
        int nodes[2];
        for (int k = 0; k < 2; ++k)
          {
            nodes[k]     = writer.add_point(end(g, k));
            const Vec2 u = end(g, k) - end(reference, k);
            displacement.insert(displacement.end(), {u.x(), u.y()});
          }
        writer.add_cell(CellShape::line, nodes, 2);
        const auto mean = [&](double dda::SpringState::*value) {
          return 0.5 * (s.points[0].*value + s.points[1].*value);
        };
        failure.push_back(static_cast<double>(s.failure));
        time.push_back(s.failure_time);
        opening.push_back(mean(&dda::SpringState::gap));
        slip.push_back(mean(&dda::SpringState::slip) - 0.5 * (s.rest_slip[0] + s.rest_slip[1]));
        normal.push_back(mean(&dda::SpringState::normal));
        shear.push_back(mean(&dda::SpringState::shear));
      }
    writer.add_point_field("displacement [m]", {"x", "y"}, std::move(displacement));
    writer.add_cell_field("failure (1 tensile, 2 shear)", std::move(failure));
    writer.add_cell_field("failure time [s]", std::move(time));
    writer.add_cell_field("opening [m]", std::move(opening));
    writer.add_cell_field("slip [m]", std::move(slip));
    writer.add_cell_field("normal stress (compression positive) [Pa]", std::move(normal));
    writer.add_cell_field("shear stress [Pa]", std::move(shear));
    if (varied_strength)
      {
        std::vector<double> factor;
        for (const dda::Joint &joint : model->joints)
          factor.push_back(joint.strength_factor);
        writer.add_cell_field("strength factor", std::move(factor));
      }
    joint_series->add(state.time, writer);
  }
} // namespace hybrid::output
