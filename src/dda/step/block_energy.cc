// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/bedrock_forces.h>
#include <hybrid/dda/springs/spring_work.h>
#include <hybrid/dda/step/block_energy.h>

namespace hybrid::dda
{
  namespace
  {
    /// One block: kinetic, stress and weight.
    void audit_block(const StepAudit &step, const std::size_t b, BlockEnergy &energy)
    {
      const Newmark         &nm = step.model.newmark;
      const double           dt = step.trial.dt, excess = nm.gamma - 0.5;
      const double           filter  = nm.filter_in(dt, step.before.last_step);
      const double           k01     = step.model.velocity_kept_in(dt);
      const MaxwellStresses &maxwell = step.stresses.branches();
      const BlockProperties &p       = step.model.blocks[b];
      const BlockState      &s       = step.before.blocks[b];
      const BlockMass       &m       = step.mass[b];
      const Vec6            &d = step.trial.increment[b], &v = step.trial.rate[b];
      const int              block = static_cast<int>(b);
      energy.kinetic += 0.5 * v.dot(m * v);
      if (k01 != 1. || step.at_rest)
        {
          const double before = 0.5 * s.velocity.dot(m * s.velocity);
          energy.damping_loss += (1. - k01 * k01) * before;
          if (step.at_rest)
            energy.integration_loss += k01 * k01 * before;
        }

      const Eigen::Vector3d e       = step.stresses.elastic_strain(d.tail<3>(), block);
      const Eigen::Vector3d plastic = step.stresses.plastic_strain(block);
      const Eigen::Vector3d stiff   = p.elasticity * e;
      const Eigen::Vector3d viscous = step.damping_time[b] / dt * stiff;
      const Eigen::Vector3d change  = step.stresses.change(stiff, e, block);
      if (maxwell.is_on())
        {
          energy.strain +=
            p.area * maxwell.stored(step.model, step.before, s.stress + change, e, block);
          energy.damping_loss += p.area * maxwell.loss(step.model, step.before, e, block);
        }
      else
        energy.strain += p.area * strain_energy_density(p.elasticity, s.stress + change);
      energy.integration_loss += excess * p.area * change.dot(e);
      if (filter > 0.)
        energy.integration_loss += filter * d.dot(m * s.acceleration_change);
      if (!step.at_rest)
        energy.integration_loss += step.kinematics.filter_loss(block, m, v);
      energy.gravity +=
        p.weight * step.model.gravity * d[1] - p.pushed_mass * step.model.horizontal * d[0];
      energy.damping_loss +=
        p.area * e.dot((1. - nm.gamma) * s.viscous_stress + nm.gamma * viscous);
      energy.yield_loss += p.area * plastic.dot((1. - nm.gamma) * (s.stress + s.viscous_stress) +
                                                nm.gamma * (s.stress + change + viscous));
    }



    /// Load of @p water on a block at the start of the step.
    WaterLoad load_at_start(const StepAudit &step, const Water &water, const int b)
    {
      const Geometry &g     = step.before.geometry;
      const int       first = g.offset[b];
      return water_load(water,
                        step.model.blocks[b].area,
                        BlockMotion(step.before.blocks[b].centroid, Vec6::Zero()),
                        {&g.vertices[first], nullptr, g.offset[b + 1] - first});
    }



    /// The same at its end.
    WaterLoad load_at_end(const StepAudit &step, const Water &water, const int b)
    {
      const Geometry &g     = step.before.geometry;
      const int       first = g.offset[b];
      return water_load(water,
                        step.model.blocks[b].area,
                        step.trial.motion[b],
                        {&g.vertices[first],
                         &step.trial.displacement[first],
                         g.offset[b + 1] - first});
    }



    /// Potential of the water's forces; what Newmark's weights make of their work beyond it is the
    /// scheme's. Where the level changes, the mean of the potential's changes below the levels of
    /// both ends is work from outside.
    void audit_water(const StepAudit &step, BlockEnergy &energy)
    {
      const double gamma   = step.model.newmark.gamma;
      const bool   changes = step.model.water.changes();
      const Water  before  = step.model.water.at(step.before.time),
                  after    = step.model.water.at(step.before.time + step.trial.dt);
      energy += shared_sum<BlockEnergy>(
        step.model.n_mass(),
        [&](const std::size_t n, BlockEnergy &sum) {
          const int       b     = static_cast<int>(n);
          const Vec6     &d     = step.trial.increment[b];
          const WaterLoad start = load_at_start(step, before, b), end = load_at_end(step, after, b);
          const Vec2      moved = d.head<2>();
          double          change;
          if (changes)
            {
              change = 0.5 * (potential_change(start, load_at_end(step, before, b), moved) +
                              potential_change(load_at_start(step, after, b), end, moved));
              sum.water_work -= change;
            }
          else
            {
              change = potential_change(start, end, moved);
              sum.gravity += change;
            }
          sum.integration_loss -= change + d.dot((1. - gamma) * start.force + gamma * end.force);
        },
        step.model.processes.get());
    }



    void audit_edge_loads(const StepAudit &step, BlockEnergy &energy)
    {
      const EdgeLoads &loads = step.model.edge_loads;
      const Geometry  &g     = step.before.geometry;
      const double     gamma = step.model.newmark.gamma;
      const double     start = (1. - gamma) * loads.factor(step.before.time);
      const double     end   = gamma * loads.factor(step.before.time + step.trial.dt);
      for (const EdgeLoads::Edge &edge : loads.edges)
        {
          const BlockMotion  at_rest(step.before.blocks[edge.block].centroid, Vec6::Zero());
          const BlockMotion &moved = step.trial.motion[edge.block];
          energy.edge_load_work += step.trial.increment[edge.block].dot(
            start * edge_force(edge, g, nullptr, at_rest) +
            end * edge_force(edge, g, step.trial.displacement.data(), moved));
        }
    }



    /// Tractions of a spring over a step, those of its contact with the weights (0, 1), its bond's
    /// without what is taken back.
    struct WeightedTraction
    {
      double                  gamma;
      const Springs::Spring  &spring;
      const SpringState      &now;
      const Springs::Traction taken;
      const Springs::Traction before = spring.contact_traction(spring.old);
      const Springs::Traction after  = spring.contact_traction(now);

      double of_bond(const double start, const double end) const
      {
        return (1. - gamma) * start + gamma * end;
      }

      double normal() const
      {
        return of_bond(spring.old.normal - before.normal,
                       now.normal - after.normal - taken.normal) +
               after.normal;
      }

      double elastic_normal() const
      {
        return of_bond(spring.old.elastic_normal - before.normal,
                       now.elastic_normal - after.normal - taken.normal) +
               after.normal;
      }

      double shear(const double start, const double end) const
      {
        const double fraction = spring.contact_fraction;
        return (1. - fraction) * of_bond(start, end) + fraction * end - gamma * taken.shear;
      }

      /// What a traction has beyond the mean of both ends.
      Springs::Traction beyond_mean(const Springs::Traction &whole,
                                    const Springs::Traction &contact) const
      {
        const double bond = gamma - 0.5;
        return {bond * (whole.normal - contact.normal) + 0.5 * contact.normal,
                bond * (whole.shear - contact.shear) + 0.5 * contact.shear};
      }
    };



    /// One joint's end or contact, by its own kinematics. What it stored before is taken off
    /// spring_replacement_loss: of the sum with the energy of all springs then, nothing is left but
    /// that of springs that are gone.
    void audit_spring(const StepAudit &step, const std::size_t i, BlockEnergy &energy)
    {
      const SpringStep         moved{step.model, step.before, step.trial, step.springs};
      const Springs::Spring   &spring   = step.springs.springs[i];
      const Springs::Response &response = step.springs.responses[i];
      const SpringState       &old = spring.old, &now = response.now;
      const WeightedTraction   traction{step.model.newmark.gamma, spring, now, response.taken_back};
      const double             shear = traction.shear(old.shear, now.shear);
      const double             gap = now.gap - old.gap, slip = now.slip - old.slip;
      const double             work    = traction.normal() * gap + shear * slip;
      const double             plastic = now.history.plastic_slip - old.history.plastic_slip;
      const double             elastic =
        traction.elastic_normal() * gap +
        traction.shear(old.elastic_shear, now.elastic_shear) * (slip - plastic);
      const double stored_before = spring.law->stored_energy({old.gap, old.slip}, old.history);
      const double stored        = spring.law->stored_energy({now.gap, now.slip}, now.history);
      const double friction      = -shear * plastic;
      const double fracture =
        spring.law->fracture_loss(now.history) - spring.law->fracture_loss(old.history);

      energy.spring_replacement_loss -= spring.length * stored_before;
      energy.springs += spring.length * stored;
      if (spring.joint >= 0 && step.model.joints[spring.joint].kind == JointKind::bedding)
        energy.bedding_loss += spring.length * (friction + fracture);
      else
        {
          energy.friction_loss += spring.length * friction;
          energy.fracture_loss += spring.length * fracture;
        }
      energy.damping_loss += spring.length * (elastic - work - friction);
      const TurningWork turning =
        turning_work(moved,
                     i,
                     traction.beyond_mean({old.normal, old.shear}, traction.before),
                     traction.beyond_mean(response.acting(), traction.after));
      energy.integration_loss += spring.length * (-elastic - (stored - stored_before) - fracture) -
                                 turning.rotation - turning.arc;
    }
  } // namespace



  BlockEnergy audit_step(const StepAudit &step)
  {
    const ProcessGroup *group  = step.model.processes.get();
    BlockEnergy         change = shared_sum<BlockEnergy>(
      step.model.blocks.size(),
      [&](const std::size_t b, BlockEnergy &sum) { audit_block(step, b, sum); },
      group);
    BlockEnergy of_springs = shared_sum<BlockEnergy>(
      step.springs.springs.size(),
      [&](const std::size_t s, BlockEnergy &sum) { audit_spring(step, s, sum); },
      group);
    of_springs.spring_replacement_loss += step.before.energy.springs;
    change += of_springs;

    BlockEnergy energy = step.before.energy;
    energy.kinetic = energy.strain = energy.springs = 0.; // those of now
    energy += change;
    if (step.model.water.action != Water::Action::none)
      audit_water(step, energy);
    if (!step.model.edge_loads.edges.empty())
      audit_edge_loads(step, energy);
    if (step.model.n_bedrock > 0)
      audit_bedrock({step.model, step.before, step.trial, step.incoming}, energy);
    return energy;
  }



  BlockEnergy stored_energy(const Model &model, const DdaState &state)
  {
    BlockEnergy energy;
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const BlockProperties &p = model.blocks[b];
        const BlockState      &s = state.blocks[b];
        energy.kinetic += 0.5 * s.velocity.dot(mass_matrix(p, s.rotation) * s.velocity);
        energy.strain +=
          p.area * (model.maxwell.is_on() ? maxwell_energy(model, state, b)
                                          : strain_energy_density(p.elasticity, s.stress));
      }
    Springs springs;
    springs.collect(model, state);
    for (const Springs::Spring &spring : springs.springs)
      energy.springs += spring.length * spring.law->stored_energy({spring.old.gap, spring.old.slip},
                                                                  spring.old.history);
    return energy;
  }
} // namespace hybrid::dda
