// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs.h>

#include <algorithm>
#include <limits>

namespace hybrid::dda
{
  namespace
  {
    Vec2 base_displacement(const Eigen::VectorXd &w, const int node)
    {
      return {w[2 * node], w[2 * node + 1]};
    }



    /**
     * Gap and slip of a vertex in front of an edge. Everything is measured from the point q of the
     * edge where the vertex projected when last accepted: differences of places far from the
     * origin, or along a long edge, would cost the digits that the residual needs.
     */
    struct ContactFrame
    {
      Vec2   outward;       ///< unit normal out of the edge's body
      Vec2   along;         ///< unit vector along the edge
      double edge_position; ///< projection of the vertex on the edge [-]
      double gap;           ///< [m]
      double slip;          ///< [m]

      /// @param from_q vertex less q.  @param edge second end less first end of the edge [m].
      ContactFrame(const Contact &contact, const Vec2 &from_q, const Vec2 &edge)
      {
        const double length = edge.norm();
        along               = edge / length;
        // Blocks run counter-clockwise, so their outside is on the right; the base's is on the
        // left.
        outward           = contact.edge_body == base_body ? Vec2(-along.y(), along.x())
                                                           : Vec2(along.y(), -along.x());
        const double slid = along.dot(from_q);
        edge_position     = contact.edge_position + slid / length;
        gap               = outward.dot(from_q);
        slip              = contact.slip + slid;
      }
    };



    /// Places of a contact's vertex and of both ends of its edge.
    struct ContactPlaces
    {
      Vec2 vertex, first, second;

      Vec2 from_q(const Contact &contact) const
      {
        return vertex - first - contact.edge_position * (second - first);
      }
    };



    ContactPlaces places(const Contact &contact, const Geometry &geometry)
    {
      ContactPlaces p;
      p.vertex = contact.vertex_body == base_body ? geometry.base_nodes[contact.vertex]
                                                  : geometry.vertices[contact.vertex];
      if (contact.edge_body == base_body)
        {
          p.first  = geometry.base_nodes[contact.edge];
          p.second = geometry.base_nodes[contact.edge + 1];
        }
      else
        {
          p.first  = geometry.vertices[contact.edge];
          p.second = geometry.vertices[geometry.next(contact.edge)];
        }
      return p;
    }



    /// The mass's law of a base where it meets base or bedrock, else that of the vertex's block.
    const ContactLaw &law_of(const Model &model, const Contact &contact)
    {
      const int vertex = contact.vertex_body, edge = contact.edge_body;
      if (vertex == base_body || edge == base_body)
        return model.base_contact[std::max(vertex, edge)];
      if (model.is_bedrock(vertex) != model.is_bedrock(edge))
        return model.base_contact[std::min(vertex, edge)];
      return model.block_contact[vertex];
    }



    /// Fill response, state and tangents of one spring from its kinematics.
    void apply_law(const Springs::Spring &spring,
                   const JointDamping    &damping,
                   Springs::Response     &response)
    {
      SpringState        &now = response.now;
      const JointResponse r = spring.law->respond({now.gap, now.slip}, spring.old.history, damping);
      now.history           = r.history;
      now.state             = r.state;
      now.normal            = r.normal;
      now.shear             = r.shear;
      now.elastic_normal    = r.elastic_normal;
      now.elastic_shear     = r.elastic_shear;
      response.normal_by_gap = r.normal_by_gap;
      response.shear_by_slip = r.shear_by_slip;
      response.shear_by_gap  = r.shear_by_gap;
    }
  } // namespace



  void Springs::collect(const Model &model, const DdaState &state)
  {
    springs.clear();
    block_pairs.clear();
    node_pairs.clear();
    collect_joints(model, state);
    collect_contacts(model, state);
    responses.resize(springs.size());
  }



  void Springs::collect_joints(const Model &model, const DdaState &state)
  {
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (state.joints[j].released || (model.hold_bedrock && joint.within_bedrock()))
          continue;
        for (int end = 0; end < 2; ++end)
          {
            Spring s;
            s.block      = joint.block;
            s.other      = joint.other;
            s.joint      = static_cast<int>(j);
            s.end        = end;
            s.law        = &joint.law;
            s.length     = 0.5 * joint.length;
            s.old        = state.joints[j].points[end];
            s.unilateral = joint.law.broken_in_tension(s.old.history);
            if (joint.other == base_body)
              {
                s.node[0] = s.node[1] = joint.points[end].other_vertex;
                node_pairs.push_back({s.block, s.node[0]});
              }
            else
              block_pairs.push_back({s.block, s.other});
            springs.push_back(s);
          }
      }
  }



  void Springs::collect_contacts(const Model &model, const DdaState &state)
  {
    const Geometry &geometry = state.geometry;
    for (std::size_t c = 0; c < state.contacts.size(); ++c)
      {
        const Contact    &contact       = state.contacts[c];
        const bool        node_on_block = contact.vertex_body == base_body;
        const bool        on_base       = node_on_block || contact.edge_body == base_body;
        const int         owner         = node_on_block ? contact.edge_body : contact.vertex_body;
        const ContactLaw &law           = law_of(model, contact);
        Spring            s;
        s.block      = owner;
        s.other      = on_base ? base_body : contact.edge_body;
        s.contact    = static_cast<int>(c);
        s.unilateral = true;
        s.law        = &law.law;
        s.length     = law.length;
        if (on_base)
          {
            s.node[0] = node_on_block ? contact.vertex : contact.edge;
            s.node[1] = node_on_block ? contact.vertex : contact.edge + 1;
            node_pairs.push_back({s.block, s.node[0]});
            node_pairs.push_back({s.block, s.node[1]});
          }
        else
          block_pairs.push_back({s.block, s.other});

        const ContactPlaces start = places(contact, geometry);
        const ContactFrame  frame(contact, start.from_q(contact), start.second - start.first);
        s.old.history.plastic_slip = contact.plastic_slip;
        s.old.gap                  = frame.gap;
        s.old.slip                 = frame.slip;
        const JointResponse r      = law.law.respond({frame.gap, frame.slip}, s.old.history);
        s.old.history              = r.history;
        s.old.normal = s.old.elastic_normal = r.normal;
        s.old.shear = s.old.elastic_shear = r.shear;
        s.old.state                       = r.state;
        springs.push_back(s);
      }
  }



  void Springs::connect(const Model &model, BlockMatrix &matrix)
  {
    const auto find_slots = [&]() {
      for (Spring &s : springs)
        if (s.other == base_body)
          {
            for (int k = 0; k < 2; ++k)
              if ((s.slot[k] = matrix.node_slot(s.block, s.node[k])) < 0)
                return false;
          }
        else if ((s.slot[0] =
                    matrix.block_slot(std::min(s.block, s.other), std::max(s.block, s.other))) < 0)
          return false;
      return true;
    };
    const bool same_size =
      matrix.n_blocks() == model.n_blocks() && matrix.n_nodes() == model.n_base_nodes();
    if (same_size && matrix.pairs.size() <= 2 * block_pairs.size() + 64 && find_slots())
      return;
    matrix.set_pattern(model.n_blocks(), model.n_base_nodes(), block_pairs, node_pairs);
    find_slots();
  }



  void Springs::evaluate(const Model &model, const DdaState &state, const Trial &trial)
  {
#pragma omp parallel for schedule(static)
    for (std::size_t s = 0; s < springs.size(); ++s)
      if (springs[s].joint >= 0)
        evaluate_joint(model, state, trial, s);
      else
        evaluate_contact(state, trial, s);
  }



  void Springs::evaluate_joint(const Model      &model,
                               const DdaState   &state,
                               const Trial      &trial,
                               const std::size_t s)
  {
    const Spring   &spring   = springs[s];
    Response       &response = responses[s];
    const Joint    &joint    = model.joints[spring.joint];
    const Geometry &geometry = state.geometry;
    const int       a = joint.edge, b = geometry.next(a);

    const auto other_place = [&](const int v) -> Vec2 {
      return joint.other == base_body
               ? Vec2(model.initial.base_nodes[v] + base_displacement(trial.base, v))
               : Vec2(geometry.vertices[v] + trial.displacement[v]);
    };
    const Vec2 pa     = geometry.vertices[a] + trial.displacement[a];
    const Vec2 pb     = geometry.vertices[b] + trial.displacement[b];
    const Vec2 q0     = other_place(joint.points[0].other_vertex),
               q1     = other_place(joint.points[1].other_vertex);
    const double part = joint.points[1].position - joint.points[0].position;
    response.tangent  = (part * (pb - pa) + (q1 - q0)).normalized();
    response.normal   = Vec2(response.tangent.y(), -response.tangent.x());

    const Joint::Point &point = joint.points[spring.end];
    const Vec2          moved_p =
      (1. - point.position) * trial.displacement[a] + point.position * trial.displacement[b];
    const int  v = point.other_vertex;
    const Vec2 moved_q =
      joint.other == base_body
        ? Vec2(base_displacement(trial.base, v) - base_displacement(state.base_displacement, v))
        : trial.displacement[v];
    // The jump is summed over the steps: differences of places would cost digits far from the
    // origin.
    SpringState &now       = response.now;
    now.jump               = spring.old.jump + moved_q - moved_p;
    now.gap                = response.normal.dot(now.jump);
    now.slip               = response.tangent.dot(now.jump);
    response.place         = (1. - point.position) * pa + point.position * pb + 0.5 * now.jump;
    response.weight[0]     = 1.;
    response.weight[1]     = 0.;
    const SpringState &old = spring.old;
    const double       damping_time =
      joint.within_bedrock() ? model.bedrock_damping_time : model.joint_damping_time;
    apply_law(spring,
              {damping_time / trial.dt, old.gap, old.slip - old.history.plastic_slip},
              response);
  }



  void Springs::evaluate_contact(const DdaState &state, const Trial &trial, const std::size_t s)
  {
    const Spring   &spring     = springs[s];
    Response       &response   = responses[s];
    const Contact  &contact    = state.contacts[spring.contact];
    const Geometry &geometry   = state.geometry;
    const auto      base_moved = [&](const int k) -> Vec2 {
      return base_displacement(trial.base, k) - base_displacement(state.base_displacement, k);
    };

    const bool    node_on_block = contact.vertex_body == base_body;
    const bool    edge_on_base  = contact.edge_body == base_body;
    ContactPlaces moved;
    moved.vertex = node_on_block ? base_moved(contact.vertex) : trial.displacement[contact.vertex];
    moved.first  = edge_on_base ? base_moved(contact.edge) : trial.displacement[contact.edge];
    moved.second =
      edge_on_base ? base_moved(contact.edge + 1) : trial.displacement[geometry.next(contact.edge)];
    const ContactPlaces start = places(contact, geometry);
    const ContactFrame  frame(contact,
                             start.from_q(contact) + moved.from_q(contact),
                             (start.second - start.first) + (moved.second - moved.first));

    response.normal        = node_on_block ? frame.outward : Vec2(-frame.outward);
    response.tangent       = node_on_block ? frame.along : Vec2(-frame.along);
    response.place         = start.vertex + moved.vertex;
    response.edge_position = frame.edge_position;
    const double xi        = std::min(1., std::max(0., frame.edge_position));
    response.weight[0]     = edge_on_base ? 1. - xi : 1.;
    response.weight[1]     = edge_on_base ? xi : 0.;
    response.now.gap       = frame.gap;
    response.now.slip      = frame.slip;
    apply_law(spring, {}, response);
  }



  double
  Springs::add_force(const std::size_t number, const Trial &trial, Eigen::VectorXd &forces) const
  {
    const Spring   &spring   = springs[number];
    const Response &response = responses[number];
    const int       nodes    = 6 * static_cast<int>(trial.motion.size());
    const Vec2      force    = spring.length * (response.now.normal * response.normal +
                                        response.now.shear * response.tangent);
    Eigen::Map<Vec6>(forces.data() + 6 * spring.block) -=
      trial.motion[spring.block].gradient(response.place, force);
    if (spring.other != base_body)
      Eigen::Map<Vec6>(forces.data() + 6 * spring.other) +=
        trial.motion[spring.other].gradient(response.place, force);
    else
      for (int k = 0; k < 2; ++k)
        {
          forces[nodes + 2 * spring.node[k]] += response.weight[k] * force.x();
          forces[nodes + 2 * spring.node[k] + 1] += response.weight[k] * force.y();
        }
    return force.norm();
  }



  void Springs::add_forces(const Trial     &trial,
                           Eigen::VectorXd &bonds,
                           Eigen::VectorXd &contacts,
                           Eigen::VectorXd &absolute) const
  {
    for (std::size_t s = 0; s < springs.size(); ++s)
      {
        const Spring &spring = springs[s];
        if (responses[s].now.normal == 0. && responses[s].now.shear == 0.)
          continue;
        const double size = add_force(s, trial, spring.unilateral ? contacts : bonds);
        absolute[spring.block] += size;
        if (spring.other != base_body)
          absolute[spring.other] += size;
      }
  }



  bool Springs::pushes_base() const
  {
    for (std::size_t s = 0; s < springs.size(); ++s)
      if (springs[s].unilateral && springs[s].other == base_body &&
          responses[s].normal_by_gap != 0.)
        return true;
    return false;
  }



  void Springs::add_stiffness(const Trial &trial, const Tangent &tangent, BlockMatrix &matrix) const
  {
    const double floor = tangent.follow_softening ? -std::numeric_limits<double>::infinity() : 0.;
    for (std::size_t s = 0; s < springs.size(); ++s)
      {
        const Spring   &spring   = springs[s];
        const Response &response = responses[s];
        const double    weight   = spring.unilateral ? tangent.contact_weight : 1.;
        const double    length   = weight * spring.length;
        const double    nn       = length * std::max(floor, response.normal_by_gap);
        const double    tt       = length * std::max(floor, response.shear_by_slip);
        const double    tn       = tangent.follow_softening || response.normal_by_gap >= 0.
                                     ? length * response.shear_by_gap
                                     : 0.;
        if (nn == 0. && tt == 0. && tn == 0.)
          continue;
        if (tn != 0. || nn < 0. || tt < 0.)
          matrix.symmetric = false;

        // K = G^T D G with rows of G along normal and tangent; the force has the rows D G.
        Eigen::Matrix<double, 2, 6> p, dp;
        p.row(0)  = trial.motion[spring.block].gradient(response.place, response.normal);
        p.row(1)  = trial.motion[spring.block].gradient(response.place, response.tangent);
        dp.row(0) = nn * p.row(0);
        dp.row(1) = tn * p.row(0) + tt * p.row(1);
        matrix.diagonal[spring.block].noalias() += p.transpose() * dp;
        if (spring.other == base_body)
          {
            Eigen::Matrix2d d;
            d << nn / weight, 0., tn / weight, tt / weight;
            add_base_stiffness(spring, response, p, d, weight, matrix);
            continue;
          }
        Eigen::Matrix<double, 2, 6> q, dq;
        q.row(0)  = trial.motion[spring.other].gradient(response.place, response.normal);
        q.row(1)  = trial.motion[spring.other].gradient(response.place, response.tangent);
        dq.row(0) = nn * q.row(0);
        dq.row(1) = tn * q.row(0) + tt * q.row(1);
        matrix.diagonal[spring.other].noalias() += q.transpose() * dq;
        const bool ordered = spring.block < spring.other;
        (ordered ? matrix.off_diagonal : matrix.lower)[spring.slot[0]].noalias() -=
          p.transpose() * dq;
        (ordered ? matrix.lower : matrix.off_diagonal)[spring.slot[0]].noalias() -=
          q.transpose() * dp;
      }
  }



  void Springs::add_base_stiffness(const Spring                      &spring,
                                   const Response                    &response,
                                   const Eigen::Matrix<double, 2, 6> &gradient,
                                   const Eigen::Matrix2d             &stiffness,
                                   const double                       weight,
                                   BlockMatrix                       &matrix)
  {
    Eigen::Matrix2d axes; // rows: normal, tangent
    axes.row(0)                             = response.normal;
    axes.row(1)                             = response.tangent;
    const Eigen::Matrix2d             nodal = axes.transpose() * stiffness * axes;
    const Eigen::Matrix<double, 6, 2> right = weight * gradient.transpose() * stiffness * axes;
    const Eigen::Matrix<double, 2, 6> left  = axes.transpose() * stiffness * gradient;
    for (int i = 0; i < 2; ++i)
      {
        const double w = response.weight[i];
        if (w == 0.)
          continue;
        matrix.block_node[spring.slot[i]] -= w * right;
        matrix.node_block[spring.slot[i]] -= w * left;
        matrix.node_diagonal[spring.node[i]] += w * w * nodal;
      }
    if (spring.node[1] == spring.node[0] + 1)
      {
        const double w = response.weight[0] * response.weight[1];
        matrix.node_next[spring.node[0]] += w * nodal;
        matrix.node_previous[spring.node[0]] += w * nodal;
      }
  }
} // namespace hybrid::dda
