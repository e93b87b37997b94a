// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/state.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  using restart::Archive;

  void serialize(Archive &archive, JointHistory &history)
  {
    auto &[plastic_slip, softening, damage, held] = history;
    archive(plastic_slip, softening, damage, held);
  }



  void serialize(Archive &archive, SpringState &spring)
  {
    auto &[history, jump, gap, slip, normal, shear, elastic_normal, elastic_shear, state] = spring;
    archive(history, jump, gap, slip, normal, shear, elastic_normal, elastic_shear, state);
  }



  void serialize(Archive &archive, JointState &joint)
  {
    auto &[points,
           failure,
           failure_time,
           has_yielded,
           released,
           handed_over,
           parted,
           rest_slip,
           drawn_gap,
           force_change] = joint;
    archive(
      points, failure, failure_time, has_yielded, released, handed_over, parted[0], parted[1]);
    archive(rest_slip[0], rest_slip[1], drawn_gap[0], drawn_gap[1], force_change);
  }



  void serialize(Archive &archive, Contact &contact)
  {
    auto &[vertex_body,
           vertex,
           edge_body,
           edge,
           edge_position,
           slip,
           plastic_slip,
           state,
           stress_free_gap,
           pressed_gap,
           closeness] = contact;
    archive(vertex_body,
            vertex,
            edge_body,
            edge,
            edge_position,
            slip,
            plastic_slip,
            state,
            stress_free_gap,
            pressed_gap,
            closeness);
  }



  void serialize(Archive &archive, BlockState &block)
  {
    auto &[centroid,
           rotation,
           velocity,
           acceleration,
           contact_acceleration,
           acceleration_change,
           velocity_change,
           stress,
           viscous_stress,
           plastic_strain,
           rest_plastic_strain] = block;
    archive(centroid, rotation, velocity, acceleration, contact_acceleration, acceleration_change);
    archive(velocity_change);
    archive(stress, viscous_stress, plastic_strain, rest_plastic_strain);
  }



  void serialize(Archive &archive, BlockEnergy &energy)
  {
    auto &[kinetic,
           strain,
           gravity,
           springs,
           friction_loss,
           yield_loss,
           bedding_loss,
           fracture_loss,
           damping_loss,
           integration_loss,
           spring_replacement_loss,
           foundation_work,
           boundary_loss,
           input_work,
           static_work,
           edge_load_work,
           water_work] = energy;
    archive(kinetic, strain, gravity, springs, friction_loss, fracture_loss, damping_loss);
    archive(integration_loss,
            spring_replacement_loss,
            foundation_work,
            boundary_loss,
            input_work,
            static_work);
    archive(edge_load_work, bedding_loss, yield_loss, water_work);
  }



  void serialize(Archive &archive, Geometry &geometry)
  {
    auto &[offset,
           block_of,
           vertices,
           foundation_nodes,
           bedrock,
           foundation_shares,
           foundation_degree]           = geometry;
    auto &[first_block, next, previous] = bedrock;
    archive(offset,
            block_of,
            vertices,
            foundation_nodes,
            first_block,
            next,
            previous,
            foundation_shares,
            foundation_degree);
  }



  void serialize(Archive &archive, RestState &rest)
  {
    auto &[vertices, foundation_nodes, settled_vertices, settled_nodes] = rest;
    archive(vertices, foundation_nodes, settled_vertices, settled_nodes);
  }



  void serialize(Archive &archive, SurfaceForce &surface)
  {
    auto &[force, shear, normal, strength] = surface;
    archive(force, shear, normal, strength);
  }



  void serialize(Archive &archive, DdaState &state)
  {
    auto &[time,
           last_step,
           geometry,
           blocks,
           branch_stress,
           joints,
           contacts,
           contact_scope,
           rest,
           foundation_displacement,
           foundation_force,
           foundation_contact_force,
           static_force,
           static_contact_force,
           bedrock_static_force,
           boundary_force,
           surface_force,
           energy] = state;
    archive(time, last_step, geometry, blocks, branch_stress, joints, contacts, contact_scope);
    archive(rest);
    archive(foundation_displacement,
            foundation_force,
            foundation_contact_force,
            static_force,
            static_contact_force,
            bedrock_static_force,
            boundary_force,
            surface_force,
            energy);
  }



  double fastest_block(const DdaState &state)
  {
    double          squared  = 0.;
    const Geometry &geometry = state.geometry;
    for (std::size_t b = 0; b < state.blocks.size(); ++b)
      {
        const BlockState &block = state.blocks[b];
        for (int v = geometry.offset[b]; v < geometry.offset[b + 1]; ++v)
          {
            const Vec2 arm = geometry.vertices[v] - block.centroid;
            const Vec2 speed =
              block.velocity.head<2>() + block.velocity[2] * Vec2(-arm.y(), arm.x());
            squared = std::max(squared, speed.squaredNorm());
          }
      }
    return std::sqrt(squared);
  }
} // namespace hybrid::dda
