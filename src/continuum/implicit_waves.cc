// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <hybrid/continuum/implicit_waves.h>

#include <algorithm>
#include <initializer_list>

namespace hybrid::continuum
{
  namespace
  {
    constexpr int most_iterations_of_step = 5000;



    void assign_zero(const std::size_t                                   size,
                     const std::initializer_list<std::vector<double> *> &vectors)
    {
      for (std::vector<double> *x : vectors)
        x->assign(size, 0.);
    }
  } // namespace



  ImplicitWaves::ImplicitWaves(const Model &model, const MPI_Comm communicator)
    : SharedWaves(model.space, communicator)
    , boundary(model.boundary)
    , damping(model.damping)
    , newmark(model.newmark)
    , cells(rock().dofs(),
            model.material,
            nothing_supported(),
            dealii::QGauss<1>(model.space.nodes.line.degree() + 1))
    , planes(model.rock,
             model.joints,
             model.space.nodes.line.degree(),
             [&model](const RockFace &face) { return model.space.nodes.along(face); })
    , place(model.space.nodes.positions.size(), -1)
  {
    if (newmark.corrected_step != 0.)
      cells.correct_inertia(newmark.corrected_step);
    find_places(model);
    find_surface(model.surface);
    allocate();
  }



  int ImplicitWaves::place_of(const int node)
  {
    if (place[node] < 0)
      {
        place[node] = static_cast<int>(list.size());
        list.push_back(node);
      }
    return place[node];
  }



  void ImplicitWaves::find_places(const Model &model)
  {
    for (const int node : boundary.boundary_nodes()) // first, as vectors on the boundary have them
      place_of(node);
    for (const int node : boundary.moving_nodes())
      moving_places.push_back(place_of(node));
    for (const int node : planes.nodes())
      joint_places.push_back(place_of(node));
    point_loads = model.loads.on_places([this](const int node) { return place_of(node); });
    places      = SharedNodes(list, unknowns(), rock().communicator());
    slots       = hold(list);
    place       = std::vector<int>();

    const std::vector<Support> &supports = boundary.supports();
    for (std::size_t k = 0; k < unknowns().size(); ++k)
      if (const Support support = supports[unknowns()[k]]; support == Support::zero)
        fixed.push_back(static_cast<unsigned int>(k));
      else if (support == Support::base_motion)
        moving[unknowns()[k] % 2].push_back(static_cast<unsigned int>(k));
  }



  void ImplicitWaves::allocate()
  {
    const std::size_t mine = unknowns().size(), edge = 2 * boundary.boundary_nodes().size(),
                      of_columns = boundary.n_column_unknowns(),
                      branches   = damping.body.n_branches();
    for (Motion *motion : {&before, &now})
      assign_zero(mine, {&motion->u, &motion->v, &motion->a});
    for (Motion *motion : {&edges0, &edges1})
      assign_zero(places.n_unknowns(), {&motion->u, &motion->v, &motion->a});
    for (Motion *motion : {&columns, &next_columns})
      assign_zero(of_columns, {&motion->u, &motion->v, &motion->a});
    assign_zero(branches * of_columns, {&column_branch, &next_column_branch});
    assign_zero(of_columns, {&column_strained});
    if (newmark.filter > 0.)
      {
        assign_zero(of_columns, {&column_change, &next_column_change});
        assign_zero(mine, {&change});
      }
    branch.assign(branches, std::vector<double>(mine, 0.));
    next_branch = branch;
    for (auto *x : {&nothing.force, &nothing.velocity, &nothing.displacement})
      x->assign(edge, 0.);
    assign_zero(mine, {&strained, &sum});
    assign_zero(edge, {&force0, &force1, &du, &du_free, &v_free, &mean});
    assign_zero(2 * joint_places.size(), {&of_joints, &joint_force});
    for (Vector *x : {&f, &a1, &work, &work2, &from_work})
      *x = cells.make_vector();
    if (surface.supported.empty())
      return;
    step_load        = cells.make_vector();
    inertia_diagonal = inverse_diagonal(inertia());
    assign_zero(mine, {&c1});
  }



  double ImplicitWaves::memory() const
  {
    constexpr double of_step  = 25.; // numbers per unknown: motion, vectors of the solver
    const double     below    = surface.supported.empty() ? 0. : 4.; // and of contacts
    const double     branches = 2. * static_cast<double>(damping.body.n_branches());
    return cells.memory() +
           sizeof(double) * (of_step + below + branches) * static_cast<double>(unknowns().size());
  }



  void ImplicitWaves::System::vmult(Vector &to, const Vector &from) const
  {
    ImplicitWaves &w = waves;
    w.cells.multiply(cells, from, to);
    if (!w.list.empty() && (joints != 0. || dashpots != 0. || springs != 0.))
      {
        w.places.gather(from.begin(), w.shared_x);
        w.shared_y.assign(w.shared_x.size(), 0.);
        w.boundary.forces(w.nothing, w.shared_x, w.edge_work);
        for (std::size_t k = 0; k < w.edge_work.size(); ++k)
          w.shared_y[k] -= dashpots * w.edge_work[k];
        if (!w.boundary.springs().empty())
          {
            w.edge_work.assign(w.edge_work.size(), 0.);
            w.boundary.springs().add_forces({w.shared_x, w.nothing.displacement}, w.edge_work);
            for (std::size_t k = 0; k < w.edge_work.size(); ++k)
              w.shared_y[k] -= springs * w.edge_work[k];
          }
        w.add_joints(joints);
        w.places.add(w.shared_y, to.begin());
      }
    w.set_supported(to, Vec2::Zero());
    if (holds_surface)
      w.hold_surface(to);
  }



  void ImplicitWaves::add_joints(const double factor)
  {
    if (joint_places.empty())
      return;
    for (std::size_t k = 0; k < of_joints.size(); ++k)
      of_joints[k] = factor * shared_x[2 * joint_places[k / 2] + k % 2];
    std::fill(joint_force.begin(), joint_force.end(), 0.);
    planes.add_product(of_joints, joint_force);
    for (std::size_t k = 0; k < joint_force.size(); ++k)
      shared_y[2 * joint_places[k / 2] + k % 2] += joint_force[k];
  }



  void ImplicitWaves::set_supported(Vector &a, const Vec2 &of_base) const
  {
    for (const unsigned int i : fixed)
      a.local_element(i) = 0.;
    for (std::size_t c = 0; c < 2; ++c)
      for (const unsigned int i : moving[c])
        a.local_element(i) = of_base[static_cast<Eigen::Index>(c)];
  }



  ImplicitWaves::System ImplicitWaves::step_system(const double dt)
  {
    const double of_velocity = newmark.gamma * dt, of_displacement = newmark.beta * dt * dt;
    const double stiffness =
      (1. + damping.body.step_modulus(dt)) * of_displacement + damping.stiffness * of_velocity;
    return {*this,
            {stiffness, 1. + damping.mass * of_velocity, 1.},
            stiffness,
            of_velocity,
            of_displacement};
  }



  ImplicitWaves::Vector ImplicitWaves::inverse_diagonal(const System &system)
  {
    Vector result = cells.diagonal(system.cells);
    if (!list.empty())
      {
        shared_y.assign(places.n_unknowns(), 0.);
        const auto dashpots = boundary.nodal_dashpots();
        for (std::size_t k = 0; k < dashpots.size(); ++k)
          for (int c = 0; c < 2; ++c)
            shared_y[2 * k + c] += system.dashpots * dashpots[k](c, c);
        planes.for_each_block([&](const int row, const int column, const Eigen::Matrix2d &block) {
          for (int c = 0; row == column && c < 2; ++c)
            shared_y[2 * joint_places[row] + c] += system.joints * block(c, c);
        });
        places.add(shared_y, result.begin());
      }
    for (double &x : result)
      x = 1. / x;
    return result;
  }



  bool ImplicitWaves::solve(const System &system,
                            const Vector &inverse,
                            const double  residual_left,
                            Vector       &load,
                            Vector       &a)
  {
    // What is known of a goes to the right.
    if (!boundary.moving_nodes().empty() || system.holds_surface)
      {
        work = 0.;
        for (const auto &along : moving)
          for (const unsigned int i : along)
            work.local_element(i) = a.local_element(i);
        for (std::size_t k = 0; system.holds_surface && k < surface.mine.size(); ++k)
          work.local_element(surface.mine[k]) = a.local_element(surface.mine[k]);
        system.vmult(work2, work);
        load -= work2;
      }
    const auto clear_known = [&](Vector &x) {
      set_supported(x, Vec2::Zero());
      if (system.holds_surface)
        hold_surface(x);
    };
    clear_known(load);
    const double size = load.l2_norm();
    from_work         = a;
    clear_known(from_work);
    system.vmult(work2, from_work);
    load -= work2;
    dealii::DiagonalMatrix<Vector> preconditioner(inverse);
    dealii::SolverControl          control(most_iterations_of_step, residual_left * size);
    dealii::SolverCG<Vector>       solver(control);
    work = 0.;
    try
      {
        solver.solve(system, work, load, preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return false;
      }
    a += work;
    return true;
  }



  void ImplicitWaves::multiply(const Weights &weights, const std::vector<double> &from, Vector &to)
  {
    std::copy(from.begin(), from.end(), from_work.begin());
    cells.multiply(weights, from_work, to);
    if (weights.stiffness == 0. || joint_places.empty())
      return;
    places.gather(from.data(), shared_x);
    shared_y.assign(shared_x.size(), 0.);
    add_joints(weights.stiffness);
    places.add(shared_y, to.begin());
  }



  void ImplicitWaves::gather(const Motion &of, Motion &at)
  {
    places.gather(of.u.data(), at.u);
    places.gather(of.v.data(), at.v);
    places.gather(of.a.data(), at.a);
  }



  void ImplicitWaves::strain(const Motion        &of,
                             const Branches      &branches,
                             std::vector<double> &result) const
  {
    const MaxwellBody &body = damping.body;
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        result[i] = body.relaxed * of.u[i] + damping.stiffness * of.v[i];
        for (std::size_t l = 0; l < branches.size(); ++l)
          result[i] += body.weight[l] * branches[l][i];
      }
  }



  void ImplicitWaves::boundary_forces(const BoundaryForces::Incoming &in,
                                      const Motion                   &at,
                                      std::vector<double>            &force) const
  {
    boundary.forces(in, at.v, force);
    if (!boundary.springs().empty())
      boundary.springs().add_forces({at.u, in.displacement}, force);
  }



  void ImplicitWaves::find_force(const Motion                   &of,
                                 const Branches                 &branches,
                                 const BoundaryForces::Incoming &in,
                                 const Motion                   &at,
                                 const double                    time)
  {
    strain(of, branches, strained);
    multiply({-1., 0., 0.}, strained, f);
    if (damping.mass != 0.)
      {
        multiply({0., -damping.mass, 0.}, of.v, work);
        f += work;
      }
    if (list.empty())
      return;
    boundary_forces(in, at, shared_y);
    shared_y.resize(places.n_unknowns(), 0.);
    point_loads.add_forces(time, shared_y);
    places.add(shared_y, f.begin());
  }



  void ImplicitWaves::predict(const double dt)
  {
    const double beta = newmark.beta, gamma = newmark.gamma;
    for (std::size_t i = 0; i < now.u.size(); ++i)
      {
        now.u[i] = before.u[i] + dt * before.v[i] + dt * dt * (0.5 - beta) * before.a[i];
        now.v[i] = before.v[i] + dt * (1. - gamma) * before.a[i];
        if (filter > 0.)
          {
            now.u[i] -= 0.5 * dt * dt * filter * change[i];
            now.v[i] -= dt * filter * change[i];
          }
      }
    for (const unsigned int i : fixed)
      now.u[i] = now.v[i] = 0.;
    advance_branches(dt);
    places.gather(now.u.data(), edges1.u);
    places.gather(now.v.data(), edges1.v);
  }



  void ImplicitWaves::advance_branches(const double dt)
  {
    for (std::size_t l = 0; l < branch.size(); ++l)
      {
        const double kept = damping.body.kept(dt, l), gained = damping.body.gained(dt, l);
        for (std::size_t i = 0; i < now.u.size(); ++i)
          next_branch[l][i] = kept * branch[l][i] + gained * (now.u[i] - before.u[i]);
      }
  }



  void ImplicitWaves::begin(const ContinuumState &state, const double dt)
  {
    load_motion(state);
    if (!state.contact_acceleration.empty())
      for (std::size_t k = 0; k < before.a.size(); ++k)
        before.a[k] -= state.contact_acceleration[k];
    filter = newmark.filter_in(dt, state.last_step);
    step_columns(state, dt);
    predict(dt);
    find_force(now, next_branch, incoming1, edges1, state.time + dt);
    std::copy(before.a.begin(), before.a.end(), a1.begin());
    set_supported(a1, boundary.base_acceleration(state.time + dt));
  }



  const ImplicitWaves::Vector &ImplicitWaves::step_diagonal(const System &system, const double dt)
  {
    if (diagonal_step != dt)
      {
        diagonal      = inverse_diagonal(system);
        diagonal_step = dt;
      }
    return diagonal;
  }



  bool ImplicitWaves::step(ContinuumState &state, const double dt)
  {
    begin(state, dt);
    const System system = step_system(dt);
    if (!solve(system, step_diagonal(system, dt), step_residual, f, a1))
      return false;
    finish(dt);
    add_energy(state, dt, SurfaceForce());
    keep_change(dt, state.last_step);
    store(state, dt);
    state.time += dt;
    return true;
  }



  void ImplicitWaves::keep_change(const double dt, const double last_step)
  {
    if (newmark.filter == 0.)
      return;
    const double kept = (1. - Newmark::memory) * Newmark::remembered_in(dt, last_step);
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] = kept * change[i] + Newmark::memory * (now.a[i] - before.a[i]);
  }



  void ImplicitWaves::finish(const double dt)
  {
    for (std::size_t i = 0; i < now.a.size(); ++i)
      {
        now.a[i] = a1.local_element(i);
        now.u[i] += newmark.beta * dt * dt * now.a[i];
        now.v[i] += newmark.gamma * dt * now.a[i];
      }
    advance_branches(dt);
    gather(now, edges1);
  }



  void ImplicitWaves::start(ContinuumState &state)
  {
    load_motion(state);
    find_incoming(state.time, columns, column_branch, incoming1);
    find_force(before, branch, incoming1, edges0, state.time);
    now = before;
    a1  = 0.;
    if (!solve(inertia(), inverse_diagonal(inertia()), fine_residual, f, a1))
      return;
    const std::vector<Support> &supports = boundary.supports();
    for (std::size_t k = 0; k < now.a.size(); ++k)
      if (supports[unknowns()[k]] == Support::none)
        now.a[k] = a1.local_element(k);
    gather(now, edges1);
    for (std::size_t k = 0; k < now.a.size(); ++k)
      state.acceleration[k] = now.a[k];
    for (std::size_t k = 0; k < edges1.a.size(); ++k)
      state.acceleration[2 * slots[k / 2] + static_cast<int>(k % 2)] = edges1.a[k];
    surface.nodes.gather(now.a.data(), surface.a);
    put_surface(surface.a, state.acceleration);
  }
} // namespace hybrid::continuum
