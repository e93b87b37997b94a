// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/spring_condition.h>
#include <hybrid/dda/springs/springs.h>
#include <hybrid/dda/springs/torn_bond.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    Vec2 foundation_displacement(const Eigen::VectorXd &w, const int node)
    {
      return {w[2 * node], w[2 * node + 1]};
    }



    /// Fill response, state and tangents of one spring.
    void set_response(const JointResponse &r, Springs::Response &response)
    {
      SpringState &now        = response.now;
      now.history             = r.history;
      now.state               = r.state;
      now.normal              = r.normal;
      now.shear               = r.shear;
      now.elastic_normal      = r.elastic_normal;
      now.elastic_shear       = r.elastic_shear;
      response.shear_strength = r.shear_strength;
      response.mohr_coulomb   = r.mohr_coulomb;
      response.k_nn           = r.k_nn;
      response.shear_by_slip  = r.shear_by_slip;
      response.k_tn           = r.k_tn;
      response.taken_back     = {0., 0.}; // the slot may have been a torn bond's
    }
    /// A bond cracks, or one that never slid begins to.
    bool fails(const Springs::Spring &bond, const JointHistory &now)
    {
      const JointHistory &before = bond.old.history;
      return bond.law->bonds() &&
             (now.damage > before.damage || (now.plastic_slip != 0. && before.plastic_slip == 0.));
    }
  } // namespace



  bool Springs::prescribe(const Model                  &model,
                          const DdaState               &state,
                          const Trial                  &trial,
                          const std::vector<Condition> &conditions)
  {
    bool any = false;
#pragma omp parallel for schedule(static) reduction(|| : any) if (is_worth_sharing(n_at_work()))
    for (std::size_t k = 0; k < n_at_work(); ++k)
      {
        const std::size_t s = at_work(k);
        if (conditions[s] == Condition::law || conditions[s] == condition(s) ||
            (!springs[s].coulomb && conditions[s] != Condition::sticks))
          continue;
        any = true;
        if (springs[s].joint >= 0)
          evaluate_joint(model, state, trial, s, conditions[s]);
        else
          evaluate_contact(state, trial, s, conditions[s]);
        set_forces(trial, s);
      }
    return any;
  }



  bool Springs::hold_bonds(const Model &model, const DdaState &state, const Trial &trial)
  {
    bool any = false;
    if (!bonds_fail)
      return any;
#pragma omp parallel for schedule(static) reduction(|| : any) if (is_worth_sharing(n_at_work()))
    for (std::size_t k = 0; k < n_at_work(); ++k)
      {
        const std::size_t s = at_work(k);
        if (s >= first_contact() || !fails(springs[s], responses[s].now.history))
          continue;
        any = true;
        evaluate_joint(model, state, trial, s, Condition::holds);
        set_forces(trial, s);
      }
    return any;
  }



  JointResponse Springs::respond(const Spring          &spring,
                                 const Condition        condition,
                                 const JointKinematics &kinematics,
                                 const JointDamping    &damping)
  {
    const JointHistory &history = spring.old.history;
    if (condition == Condition::holds)
      return spring.law->respond_whole(kinematics, history, damping);
    if (condition != Condition::law && spring.coulomb)
      return spring.law->respond_in(condition, kinematics, history, damping);
    if (condition == Condition::sticks)
      return spring.law->respond_locked(kinematics, history, damping);
    return spring.law->respond(kinematics, history, damping);
  }



  void Springs::narrow(const std::vector<int> &blocks, const std::vector<int> &nodes)
  {
    chosen = &narrow_ones;
    narrow_ones.clear();
    is_marked.assign(springs.size(), 0);
    const auto add = [&](const int s) {
      if (is_marked[s] == 0)
        narrow_ones.push_back(s);
      is_marked[s] = 1;
    };
    for (const int b : blocks)
      for (const int entry : of_block(b))
        add(entry / 2);
    if (nodes.empty())
      return;
    for (const int s : on_foundation())
      for (const int node : bodies[s].node)
        if (std::binary_search(nodes.begin(), nodes.end(), node))
          add(s);
  }



  void Springs::evaluate(const Model &model, const DdaState &state, const Trial &trial)
  {
    bool fail = false;
#pragma omp parallel for schedule(static) reduction(|| : fail) if (is_worth_sharing(n_at_work()))
    for (std::size_t k = 0; k < n_at_work(); ++k)
      {
        const std::size_t s = at_work(k);
        if (springs[s].joint >= 0)
          {
            evaluate_joint(model, state, trial, s);
            fail = fail || fails(springs[s], responses[s].now.history);
          }
        else
          evaluate_contact(state, trial, s);
        set_forces(trial, s);
      }
    bonds_fail = fail || (chosen != nullptr && bonds_fail);
  }



  void Springs::evaluate_joint(const Model      &model,
                               const DdaState   &state,
                               const Trial      &trial,
                               const std::size_t s,
                               const Condition   condition)
  {
    const Spring   &spring   = springs[s];
    Response       &response = responses[s];
    const Joint    &joint    = model.joints[spring.joint];
    const Geometry &geometry = state.geometry;
    const int       a = joint.edge, b = geometry.next(a);

    const auto other_place = [&](const int v) -> Vec2 {
      return joint.other == foundation_body ? Vec2(model.initial.foundation_nodes[v] +
                                                   foundation_displacement(trial.foundation, v))
                                            : Vec2(geometry.vertices[v] + trial.displacement[v]);
    };
    const Vec2 pa         = geometry.vertices[a] + trial.displacement[a];
    const Vec2 pb         = geometry.vertices[b] + trial.displacement[b];
    const Vec2 q0         = other_place(joint.points[0].other_vertex),
               q1         = other_place(joint.points[1].other_vertex);
    const double fraction = joint.points[1].position - joint.points[0].position;
    response.tangent      = (fraction * (pb - pa) + (q1 - q0)).normalized();
    response.normal       = Vec2(response.tangent.y(), -response.tangent.x());

    const Joint::Point &point = joint.points[spring.end];
    const Vec2          moved_p =
      (1. - point.position) * trial.displacement[a] + point.position * trial.displacement[b];
    const int  v       = point.other_vertex;
    const Vec2 moved_q = joint.other == foundation_body
                           ? Vec2(foundation_displacement(trial.foundation, v) -
                                  foundation_displacement(state.foundation_displacement, v))
                           : trial.displacement[v];
    // The jump is summed over the steps: differences of places would cost digits far from the
    // origin.
    const SpringState &old = spring.old;
    SpringState       &now = response.now;
    now.jump               = old.jump + moved_q - moved_p;
    now.gap                = response.normal.dot(now.jump);
    now.slip               = response.tangent.dot(now.jump);
    response.place         = (1. - point.position) * pa + point.position * pb + 0.5 * now.jump;
    response.weight[0]     = 1.;
    response.weight[1]     = 0.;
    const double damping_time =
      joint.within_bedrock() ? model.bedrock_damping_time : model.joint_damping_time;
    const JointDamping    damping{damping_time / trial.dt,
                               old.gap,
                               old.slip - old.history.plastic_slip};
    const JointKinematics kinematics{now.gap, now.slip, spring.cohesion_length_ratio, trial.dt};
    set_response(respond(spring, condition, kinematics, damping), response);
    if (now.history.damage == old.history.damage && old.history.held == 0.)
      return; // nothing tears
    const TakenBack taken = taken_back(spring, now, model.newmark.gamma);
    response.taken_back   = taken.traction;
    response.k_nn += taken.by_gap;
    response.shear_by_slip += taken.by_slip;
  }



  void Springs::evaluate_contact(const DdaState   &state,
                                 const Trial      &trial,
                                 const std::size_t s,
                                 const Condition   condition)
  {
    const Spring   &spring           = springs[s];
    Response       &response         = responses[s];
    const Contact  &contact          = state.contacts[spring.contact];
    const Geometry &geometry         = state.geometry;
    const auto      foundation_moved = [&](const int k) -> Vec2 {
      return foundation_displacement(trial.foundation, k) -
             foundation_displacement(state.foundation_displacement, k);
    };

    const bool    node_on_block      = contact.vertex_body == foundation_body;
    const bool    edge_on_foundation = contact.edge_body == foundation_body;
    ContactPlaces moved;
    moved.vertex =
      node_on_block ? foundation_moved(contact.vertex) : trial.displacement[contact.vertex];
    moved.first =
      edge_on_foundation ? foundation_moved(contact.edge) : trial.displacement[contact.edge];
    moved.second              = edge_on_foundation ? foundation_moved(contact.edge + 1)
                                                   : trial.displacement[geometry.next(contact.edge)];
    const ContactPlaces start = places(contact, geometry);
    const ContactFrame  frame(contact, start, spring.along, moved);

    response.normal        = node_on_block ? frame.outward : Vec2(-frame.outward);
    response.tangent       = node_on_block ? frame.along : Vec2(-frame.along);
    response.place         = start.vertex + moved.vertex;
    response.edge_position = frame.edge_position;
    const double xi        = std::min(1., std::max(0., frame.edge_position));
    response.weight[0]     = edge_on_foundation ? 1. - xi : 1.;
    response.weight[1]     = edge_on_foundation ? xi : 0.;

    const JointKinematics kinematics{frame.gap - contact.stress_free_gap,
                                     frame.slip,
                                     spring.cohesion_length_ratio,
                                     trial.dt};
    response.now.gap  = kinematics.gap;
    response.now.slip = kinematics.slip;
    set_response(respond(spring, condition, kinematics, {}), response);
  }



  Springs::Forces
  Springs::forces_of(const Trial &trial, const std::size_t s, const Traction &traction) const
  {
    const Spring   &spring   = springs[s];
    const Response &response = responses[s];
    const Vec2      force =
      spring.length * (traction.normal * response.normal + traction.shear * response.tangent);
    Forces result;
    result.on_block = -trial.motion[spring.block].gradient(response.place, force);
    if (spring.other != foundation_body)
      result.on_other = trial.motion[spring.other].gradient(response.place, force);
    return result;
  }



  void Springs::set_forces(const Trial &trial, const std::size_t s)
  {
    const Spring      &spring = springs[s];
    const SpringState &now    = responses[s].now;
    bearing[s]                = {Role::none, condition_of(now)};
    const Traction acting     = responses[s].acting();
    if (acting.normal == 0. && acting.shear == 0.)
      return;
    forces[s] = forces_of(trial, s, acting);
    if (spring.part >= 0)
      {
        bearing[s].role            = Role::both;
        contact_parts[spring.part] = forces_of(trial, s, spring.contact_traction(now));
      }
    else
      bearing[s].role = spring.contact_fraction == 1. ? Role::contact : Role::bond;
  }



  void Springs::add_force(const Trial      &trial,
                          const std::size_t s,
                          const Traction   &traction,
                          Eigen::VectorXd  &sum) const
  {
    if (traction.normal == 0. && traction.shear == 0.)
      return;
    const Spring &spring = springs[s];
    const Forces  force  = forces_of(trial, s, traction);
    Eigen::Map<Vec6>(sum.data() + 6 * spring.block) += force.on_block;
    if (spring.other != foundation_body)
      Eigen::Map<Vec6>(sum.data() + 6 * spring.other) += force.on_other;
    else
      add_force_on_foundation(s, force, sum);
  }



  void Springs::add_force_on_foundation(const std::size_t s,
                                        const Forces     &force,
                                        Eigen::VectorXd  &sum) const
  {
    const Spring   &spring   = springs[s];
    const Response &response = responses[s];
    double         *nodes    = sum.data() + 6 * n_blocks();
    for (int k = 0; k < 2; ++k)
      Eigen::Map<Vec2>(nodes + 2 * spring.node[k]) -= response.weight[k] * force.on_block.head<2>();
  }



  void Springs::add_forces(Eigen::VectorXd        &bonds,
                           Eigen::VectorXd        &contacts,
                           Eigen::VectorXd        &absolute,
                           const std::vector<int> *blocks) const
  {
    const int n = blocks != nullptr ? static_cast<int>(blocks->size()) : n_blocks();
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int k = 0; k < n; ++k)
      {
        const int b    = blocks != nullptr ? (*blocks)[k] : k;
        Vec6      bond = Vec6::Zero(), contact = Vec6::Zero();
        for (const int entry : of_block(b))
          {
            const int  s    = entry / 2;
            const Role role = bearing[s].role;
            if (role == Role::none)
              continue;
            const auto on_this = [entry](const Forces &force) -> const Vec6 & {
              return entry % 2 == 0 ? force.on_block : force.on_other;
            };
            const Vec6 &force = on_this(forces[s]);
            if (role != Role::both)
              (role == Role::contact ? contact : bond) += force;
            else
              {
                const Vec6 &part = on_this(contact_parts[springs[s].part]);
                contact += part;
                bond += force - part;
              }
            absolute[b] += force.head<2>().norm();
          }
        Eigen::Map<Vec6>(bonds.data() + 6 * b) += bond;
        Eigen::Map<Vec6>(contacts.data() + 6 * b) += contact;
      }
    add_forces_on_foundation(bonds, contacts);
  }



  void Springs::add_forces_on_foundation(Eigen::VectorXd &bonds, Eigen::VectorXd &contacts) const
  {
    for (const int s : on_foundation())
      {
        const Role role = bearing[s].role;
        if (role == Role::none)
          continue;
        if (role != Role::both)
          {
            add_force_on_foundation(s, forces[s], role == Role::contact ? contacts : bonds);
            continue;
          }
        const Forces &part = contact_parts[springs[s].part];
        add_force_on_foundation(s, part, contacts);
        Forces bond = forces[s];
        bond.on_block -= part.on_block;
        add_force_on_foundation(s, bond, bonds);
      }
  }
} // namespace hybrid::dda
