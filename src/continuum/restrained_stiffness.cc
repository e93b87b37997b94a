// SPDX-License-Identifier: GPL-3.0-or-later
#include <deal.II/dofs/dof_tools.h>

#include <hybrid/continuum/restrained_stiffness.h>

#include <stdexcept>

namespace hybrid::continuum
{
  using namespace dealii;

  namespace
  {
    /// What of @p supported this rank has to do with.
    AffineConstraints<double> make_constraints(const SharedRock        &shared,
                                               const std::vector<char> &supported)
    {
      IndexSet relevant;
      DoFTools::extract_locally_relevant_dofs(shared.dofs(), relevant);
      ElasticProduct::Vector flag(shared.dofs().locally_owned_dofs(),
                                  relevant,
                                  shared.communicator());
      for (std::size_t i = 0; i < shared.unknowns().size(); ++i)
        flag.local_element(i) = supported[shared.unknowns()[i]];
      flag.update_ghost_values();
      AffineConstraints<double> result(relevant);
      for (const auto i : relevant)
        if (flag(i) != 0.)
          result.add_line(i);
      result.close();
      return result;
    }
  } // namespace



  RestrainedStiffness::RestrainedStiffness(const RestrainedModel &model)
    : shared_rock(model.shared)
    , constraints(make_constraints(model.shared, model.supported))
    , cells(model.shared.dofs(),
            model.material,
            constraints,
            QGauss<1>(model.nodes.line.degree() + 1))
    , planes(model.rock,
             model.joints,
             model.nodes.line.degree(),
             [&model](const RockFace &face) { return model.nodes.along(face); })
    , places(planes.nodes(), model.shared.unknowns(), model.shared.communicator())
  {
    const std::vector<int> &unknowns = model.shared.unknowns();
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (model.supported[unknowns[i]])
        held.push_back(static_cast<unsigned int>(i));
    for (const int node : planes.nodes())
      for (int c = 0; c < 2; ++c)
        held_places.push_back(model.supported[2 * node + c]);
  }



  void RestrainedStiffness::vmult(Vector &f, const Vector &u) const
  {
    cells.multiply(1., u, f);
    if (!planes.nodes().empty())
      {
        places.gather(u.begin(), shared_u);
        places.gather(f.begin(), shared_f);
        for (std::size_t k = 0; k < shared_u.size(); ++k)
          if (held_places[k])
            shared_u[k] = 0.;
        planes.add_product(shared_u, shared_f);
        places.scatter(shared_f, f.begin());
      }
    for (const unsigned int i : held)
      f.local_element(i) = u.local_element(i);
  }



  RestrainedStiffness::Vector RestrainedStiffness::diagonal() const
  {
    Vector result = cells.diagonal({1., 0., 0.});
    if (planes.nodes().empty())
      return result;
    places.gather(result.begin(), shared_f);
    planes.for_each_block([&](const int row, const int column, const Eigen::Matrix2d &block) {
      for (int c = 0; row == column && c < 2; ++c)
        if (!held_places[2 * row + c])
          shared_f[2 * row + c] += block(c, c);
    });
    places.scatter(shared_f, result.begin());
    return result;
  }



  void RestrainedStiffness::support(Vector &x) const
  {
    for (const unsigned int i : held)
      x.local_element(i) = 0.;
  }



  types::global_dof_index RestrainedStiffness::m() const
  {
    return shared_rock.dofs().n_dofs();
  }



  double RestrainedStiffness::el(unsigned int, unsigned int) const
  {
    throw std::logic_error("RestrainedStiffness has no entries");
  }
} // namespace hybrid::continuum
