// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/banded_condensation.h>
#include <hybrid/continuum/continuum_implementation.h>
#include <hybrid/continuum/elastic_assembly.h>
#include <hybrid/continuum/explicit_waves.h>
#include <hybrid/continuum/implicit_waves.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace hybrid::continuum
{
  namespace
  {
    std::vector<Material> materials_of_regions(const scene::SectionMesh     &mesh,
                                               const scene::SceneParameters &scene)
    {
      std::vector<Material> result;
      for (const auto &region : mesh.bedrock_region_names)
        result.push_back(scene.bedrock_material(region));
      return result;
    }

    std::vector<RockFace> faces_of_lines(const RockMesh                 &rock,
                                         const scene::SectionMesh       &mesh,
                                         const std::vector<std::string> &names)
    {
      std::vector<RockFace> faces;
      for (const auto &name : names)
        if (const auto line = mesh.lines.find(name); line != mesh.lines.end())
          for (const auto &face : boundary_faces(rock, line->second))
            faces.push_back(face);
      return faces;
    }

    /// Faces of a side that hang together, from below: planes that end there part it.
    std::vector<std::vector<RockFace>> parts_of_side(const RockMesh       &rock,
                                                     std::vector<RockFace> faces)
    {
      for (RockFace &face : faces)
        if (rock.nodes[face.a].y() > rock.nodes[face.b].y())
          std::swap(face.a, face.b);
      std::sort(faces.begin(), faces.end(), [&](const RockFace &f, const RockFace &g) {
        return rock.nodes[f.a].y() + rock.nodes[f.b].y() <
               rock.nodes[g.a].y() + rock.nodes[g.b].y();
      });
      std::vector<std::vector<RockFace>> parts;
      for (const RockFace &face : faces)
        {
          if (parts.empty() || parts.back().back().b != face.a)
            parts.emplace_back();
          parts.back().push_back(face);
        }
      return parts;
    }



    std::vector<int> nodes_of_faces(const ElementNodes &nodes, const std::vector<RockFace> &faces)
    {
      std::set<int> result;
      for (const auto &face : faces)
        for (const int node : nodes.along(face))
          result.insert(node);
      return {result.begin(), result.end()};
    }

    double cell_area(const RockMesh &rock, const std::size_t cell)
    {
      double twice = 0.;
      for (int i = 0; i < 4; ++i)
        twice += cross(rock.nodes[rock.cells[cell][i]], rock.nodes[rock.cells[cell][(i + 1) % 4]]);
      return 0.5 * std::abs(twice);
    }

    // When of S a band is kept (doc/scaling.md).
    constexpr int long_surface             = 6000; ///< its unknowns, at least
    constexpr int narrow_band              = 4;    ///< unknowns of the surface over the band's
    constexpr int nodes_of_unresolved_wave = 30;   ///< that entries reach over in any step

    /// Nodes of the contact surface, and what each bears of the load between it and the next.
    struct Surface
    {
      std::vector<int>    nodes;
      std::vector<double> shares;
    };

    Surface
    surface_of(const RockMesh &rock, const scene::SectionMesh &mesh, const ElementNodes &nodes)
    {
      const auto faces = faces_of_lines(rock, mesh, {"sliding_surface", "ground"});
      if (faces.empty())
        throw InputError("Mesh: blocks on bedrock need a line 'sliding_surface' or 'ground' on the "
                         "boundary of the bedrock, and there is none.");
      const std::vector<double> shares = nodes.line.load_shares();
      Surface                   surface;
      for (const auto &face : surface_chain(rock, faces))
        {
          const std::vector<int> along = nodes.along({face.cell, face.b, face.a});
          if (!surface.nodes.empty() && surface.nodes.back() != along.front())
            surface.shares.push_back(
              0.5); // two nodes at one place, where a bedding plane crops out
          if (surface.nodes.empty() || surface.nodes.back() != along.front())
            surface.nodes.push_back(along.front());
          surface.nodes.insert(surface.nodes.end(), along.begin() + 1, along.end());
          surface.shares.insert(surface.shares.end(), shares.begin(), shares.end());
        }
      return surface;
    }
  } // namespace


  Continuum::Continuum(const scene::SectionMesh     &mesh,
                       const scene::SceneParameters &scene,
                       const scene::GroundMotion    &motion,
                       MPI_Comm                      communicator)
    : impl(std::make_unique<Implementation>())
  {
    if (mesh.bedrock_cells.empty())
      throw InputError("Mesh: the continuum needs bedrock cells, and there are none.");
    impl->take_rock(mesh, scene);
    if (scene.continuum.is_explicit ||
        scene.continuum.linear_solver == scene::LinearSolver::conjugate_gradients)
      impl->make_waves(mesh, scene, motion, communicator);
    else
      impl->make_system(mesh, scene, motion, communicator);
    impl->add_wave(scene.initial_wave, mesh);
    impl->facing = impl->find_facing_nodes();
  }


  Continuum::~Continuum() = default;


  void Continuum::Implementation::take_rock(const scene::SectionMesh     &mesh,
                                            const scene::SceneParameters &scene)
  {
    cell_region        = mesh.bedrock_region;
    cell_material      = CellMaterials(materials_of_regions(mesh, scene), cell_region);
    newmark            = scene.time.newmark;
    rayleigh_mass      = scene.continuum.rayleigh_mass;
    rayleigh_stiffness = scene.continuum.rayleigh_stiffness;
    rock               = split_bedding_planes(mesh, scene.bedding.names);
    joint_stiffness    = {scene.bedding.normal_stiffness, scene.bedding.shear_stiffness};
  }


  void Continuum::Implementation::take_static_model(const scene::SectionMesh     &mesh,
                                                    const scene::SceneParameters &scene)
  {
    has_weight  = scene.environment.gravity > 0.;
    left_nodes  = nodes_of_faces(*nodes, faces_of_lines(rock, mesh, {"left"}));
    right_nodes = nodes_of_faces(*nodes, faces_of_lines(rock, mesh, {"right"}));
    base_nodes  = nodes_of_faces(*nodes, faces_of_lines(rock, mesh, {"base"}));
    for (const auto &[name, outward] : {std::pair("left", -1.), std::pair("right", 1.)})
      for (const auto &part : parts_of_side(rock, faces_of_lines(rock, mesh, {name})))
        side_parts.push_back({nodes_of_faces(*nodes, part), outward});
    if (scene.environment.has_initial_stress())
      initial_stress = std::make_unique<InitialRockStress>(
        scene::InitialStress(mesh, scene), cell_region, rock, *nodes, joint_stiffness);
  }


  void Continuum::Implementation::make_waves(const scene::SectionMesh     &mesh,
                                             const scene::SceneParameters &scene,
                                             const scene::GroundMotion    &motion,
                                             MPI_Comm                      communicator)
  {
    const bool   is_explicit = scene.continuum.is_explicit;
    ElementSpace space(rock,
                       mesh,
                       scene.continuum.degree,
                       MPI_COMM_SELF,
                       is_explicit ? MassQuadrature::lobatto : MassQuadrature::gauss);
    nodes    = space.all_nodes;
    boundary = std::make_unique<BoundaryForces>(rock, *nodes, cell_material, mesh, scene, motion);
    add_point_loads(scene.point_loads);
    const RockDamping damping{rayleigh_mass, rayleigh_stiffness, make_maxwell(scene.maxwell)};
    if (is_explicit)
      waves = std::make_unique<ExplicitWaves>(
        rock, space, cell_material, joint_stiffness, point_loads, *boundary, damping, communicator);
    else
      {
        take_surface(mesh, scene);
        auto steps    = std::make_unique<ImplicitWaves>(ImplicitWaves::Model{rock,
                                                                          space,
                                                                          cell_material,
                                                                          joint_stiffness,
                                                                          point_loads,
                                                                          *boundary,
                                                                          damping,
                                                                          newmark,
                                                                          surface},
                                                     communicator);
        below_blocks  = surface.empty() ? nullptr : steps.get();
        waves         = std::move(steps);
        surface_slots = waves->ownership().held().slots(surface);
        make_band(scene);
      }
    take_static_model(mesh, scene);
  }



  void Continuum::Implementation::take_surface(const scene::SectionMesh     &mesh,
                                               const scene::SceneParameters &scene)
  {
    if (scene.blocks.enabled && (!mesh.blocks.empty() || !scene.mesh.polygons_file.empty()))
      {
        Surface under_blocks = surface_of(rock, mesh, *nodes);
        surface              = std::move(under_blocks.nodes);
        surface_shares       = std::move(under_blocks.shares);
      }
    for (const int node : surface)
      surface_positions.push_back(nodes->positions[node]);
    surface_load = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(surface.size()));
  }


  void Continuum::Implementation::make_system(const scene::SectionMesh     &mesh,
                                              const scene::SceneParameters &scene,
                                              const scene::GroundMotion    &motion,
                                              MPI_Comm                      communicator)
  {
    {
      const ElementSpace space(rock, mesh, scene.continuum.degree, communicator);
      nodes = space.all_nodes;
      matrices =
        assemble_elastic(space, rock, cell_material, joint_stiffness, newmark.corrected_step);
    }
    boundary = std::make_unique<BoundaryForces>(rock, *nodes, cell_material, mesh, scene, motion);
    take_static_model(mesh, scene);
    take_surface(mesh, scene);
    surface_slots = surface;
    may_find_band = finds_band(scene);
    number_system();
    make_condensation(scene);
    allocate_work();
    if (scene.bedding.slips && !rock.joints.empty())
      prepare_slip(scene.bedding);
    prepare_maxwell(scene.maxwell);
    add_point_loads(scene.point_loads);
  }


  void Continuum::Implementation::number_system()
  {
    const auto       &supports = boundary->supports();
    std::vector<char> isolated(n_dofs(), 0);
    system_of_dof.assign(n_dofs(), -1);
    std::vector<char> on_surface(nodes->size(), 0);
    for (const int node : surface)
      on_surface[node] = 1;
    const auto append = [&](const int dof) {
      system_of_dof[dof] = static_cast<int>(dof_of_system.size());
      dof_of_system.push_back(dof);
    };
    for (std::size_t i = 0; i < n_dofs(); ++i)
      if (!on_surface[i / 2] && supports[i] == Support::none)
        append(static_cast<int>(i));
      else if (supports[i] == Support::zero)
        fixed_dofs.push_back(static_cast<int>(i));
    for (const int node : surface)
      for (int c = 0; c < 2; ++c)
        {
          isolated[2 * node + c] = supports[2 * node + c] != Support::none;
          append(2 * node + c);
        }
    pattern = make_system_pattern(matrices, system_of_dof, dof_of_system, isolated);
  }


  int Continuum::Implementation::expected_reach(const scene::SceneParameters &scene) const
  {
    // A surface that moves at one place brings u'' = u/l^2 with it, l = c sqrt(beta) dt; elements
    // that do not resolve l let it fall less.
    double fastest = 0.;
    for (std::size_t c = 0; c < cell_material.size(); ++c)
      fastest = std::max(fastest, cell_material[c].p_wave_speed());
    const double dt = scene.time.time_step, beta = newmark.beta;
    const double damped = 1. + newmark.gamma / (beta * dt) * rayleigh_stiffness;
    const double folds =
      std::log(2. * static_cast<double>(surface.size()) / std::numeric_limits<double>::epsilon());
    const double way    = folds * fastest * std::sqrt(beta * damped) * dt;
    int          widest = 0; // in nodes
    for (std::size_t first = 0, last = 0; last < surface.size(); ++last)
      {
        while ((surface_positions[last] - surface_positions[first]).norm() > way)
          ++first;
        widest = std::max(widest, static_cast<int>(last - first));
      }
    return 2 * (widest + nodes_of_unresolved_wave);
  }


  bool Continuum::Implementation::finds_band(const scene::SceneParameters &scene) const
  {
    const int n = 2 * static_cast<int>(surface.size());
    return n < long_surface || narrow_band * expected_reach(scene) <= n;
  }


  void Continuum::Implementation::make_band(const scene::SceneParameters &scene)
  {
    if (below_blocks == nullptr)
      return;
    const int reach = expected_reach(scene), n = 2 * static_cast<int>(surface.size());
    if (!finds_band(scene))
      {
        std::ostringstream text;
        text << "Continuum/Linear solver = conjugate gradients: in a step of "
             << scene.time.time_step
             << " s waves go so far along the surface below the blocks that "
             << std::min(2 * reach, n) << " of its " << n
             << " unknowns feel each other, and there is no band to be found; set a shorter "
                "Time/Time step, or Continuum/Linear solver = factor";
        throw InputError(text.str());
      }
    is_banded = true;
    // three step sizes, and one that is found
    band_memory = 4. * sizeof(double) * std::min(reach + 1., 1. * n) * n;
  }


  void Continuum::Implementation::make_condensation(const scene::SceneParameters &scene)
  {
    const int n = 2 * static_cast<int>(surface.size());
    if (n > 0 && scene.continuum.surface_form != scene::SurfaceForm::dense)
      {
        const int reach = expected_reach(scene);
        is_banded       = scene.continuum.surface_form == scene::SurfaceForm::banded ||
                    (n >= long_surface && finds_band(scene));
        if (is_banded)
          {
            factorisation =
              std::make_unique<BandedCondensation>(pattern.column_start, pattern.row, n, reach);
            return;
          }
      }
    factorisation = std::make_unique<CondensedFactorisation>(pattern.column_start, pattern.row, n);
  }


  void Continuum::Implementation::add_point_loads(const scene::PointLoadParameters &parameters)
  {
    point_loads = PointLoads(parameters);
    for (const scene::PointLoad &given : parameters.loads)
      {
        const auto  point = cell_point(given.position, "Point loads/Forces: '" + given.name + "'");
        const auto &cell  = nodes->cells[point.cell];
        for (std::size_t k = 0; k < cell.size(); ++k)
          if (point.weights[k] != 0. && boundary->supports()[2 * cell[k]] == Support::base_motion)
            throw InputError(
              "Point loads/Forces: '" + given.name +
              "' acts on the rigid base or a cell at it, whose motion is prescribed.");
        point_loads.add(cell, point.weights, given.peak);
      }
  }


  void Continuum::Implementation::allocate_work()
  {
    for (auto *x :
         {&predicted, &rate, &load, &product, &product2, &mean, &du, &da, &u1, &v1, &a0, &a1})
      x->assign(n_dofs(), 0.);
    rhs.assign(dof_of_system.size(), 0.);
    solution.assign(dof_of_system.size(), 0.);
    for (auto *x : {&column_u, &column_v, &column_a, &column_change})
      x->assign(boundary->n_column_unknowns(), 0.);
    for (auto *x : {&edge0, &edge1, &edge_force0, &edge_force1, &edge_du, &edge_du_ff, &edge_v_ff})
      x->assign(2 * boundary->boundary_nodes().size(), 0.);
    if (!boundary->springs().empty())
      for (auto *x : {&edge_u0, &edge_u1, &edge_u_ff})
        x->assign(2 * boundary->boundary_nodes().size(), 0.);
    surface_motion = surface_load;
  }


  ContinuumState Continuum::initial_state() const
  {
    ContinuumState    state;
    const std::size_t n = impl->n_held() + impl->boundary->n_column_unknowns();
    state.displacement.assign(n, 0.);
    state.velocity.assign(n, 0.);
    state.acceleration.assign(n, 0.);
    if (impl->newmark.filter > 0.)
      state.acceleration_change.assign(n, 0.);
    state.surface_force.assign(2 * impl->surface.size(), 0.);
    if (impl->slip != nullptr)
      {
        state.slip        = impl->slip->initial_state();
        state.column_slip = impl->boundary->column_slip_at_rest();
      }
    state.maxwell =
      impl->waves != nullptr ? impl->maxwell.strains_at_rest(n) : impl->maxwell.at_rest();
    return state;
  }


  std::size_t Continuum::n_unknowns() const
  {
    return impl->n_dofs();
  }


  const std::vector<Vec2> &Continuum::surface_nodes() const
  {
    return impl->surface_positions;
  }


  const std::vector<double> &Continuum::surface_shares() const
  {
    return impl->surface_shares;
  }


  Continuum::Resolution Continuum::resolution() const
  {
    const auto &m = *impl;
    Resolution  result;
    result.cells             = static_cast<int>(m.nodes->cells.size());
    result.surface_unknowns  = 2 * m.surface.size();
    result.surface_is_banded = m.is_banded;
    result.finds_band        = m.may_find_band;
    result.slowest_s_wave = result.highest_frequency = 1e300;
    const int p                                      = m.nodes->line.degree();
    double    s_way = 0., powers = 0.;
    for (std::size_t c = 0; c < m.nodes->cells.size(); ++c)
      {
        const double s       = m.cell_material[c].s_wave_speed();
        double       longest = 0.;
        for (int i = 0; i < 4; ++i)
          longest = std::max(
            longest,
            (m.rock.nodes[m.rock.cells[c][(i + 1) % 4]] - m.rock.nodes[m.rock.cells[c][i]]).norm());
        result.slowest_s_wave = std::min(result.slowest_s_wave, s);
        result.fastest_p_wave = std::max(result.fastest_p_wave, m.cell_material[c].p_wave_speed());
        result.highest_frequency = std::min(result.highest_frequency, s * p / (10. * longest));
        const double area        = cell_area(m.rock, c);
        s_way += area / s;
        powers += area / s * std::pow(longest / s, 2 * p);
        result.p_time += area / m.cell_material[c].p_wave_speed();
      }
    const auto [left, right] =
      std::minmax_element(m.rock.nodes.begin(),
                          m.rock.nodes.end(),
                          [](const Vec2 &a, const Vec2 &b) { return a.x() < b.x(); });
    const double width = right->x() - left->x();
    result.s_time      = s_way / width;
    result.p_time /= width;
    result.cell_time = std::pow(powers / s_way, 0.5 / p);
    return result;
  }


  double Continuum::uncorrected_part(const double dt, const bool pressure) const
  {
    const auto &m    = *impl;
    double      part = 0., way = 0.;
    for (std::size_t c = 0; c < m.nodes->cells.size(); ++c)
      {
        const Material &material = m.cell_material[c];
        const double    speed    = pressure ? material.p_wave_speed() : material.s_wave_speed();
        const double    area     = cell_area(m.rock, c);
        const double q = 0.5 * std::pow(dt * speed * m.nodes->line.degree() / std::sqrt(area), 4);
        part += area / speed * q / (1. + q);
        way += area / speed;
      }
    return part / way;
  }


  double Continuum::estimated_memory() const
  {
    if (impl->waves != nullptr)
      return impl->waves->memory() + impl->band_memory +
             (impl->has_weight ? impl->waves->static_memory() : 0.);
    double numbers = static_cast<double>(impl->matrices.stiffness.size() +
                                         impl->matrices.inertia_correction.size());
    if (impl->slip != nullptr)
      {
        // Compliance of the node pairs, and the products that make it a relaxation of the points.
        const double pairs  = 2. * static_cast<double>(impl->slip->planes().node_pairs().size());
        const double points = 2. * static_cast<double>(impl->slip->planes().points().size());
        numbers += pairs * pairs + 2. * pairs * points + 2. * points * points;
      }
    return sizeof(double) * numbers + impl->factorisation->factor_memory();
  }
} // namespace hybrid::continuum
