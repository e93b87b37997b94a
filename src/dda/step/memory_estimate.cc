// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block/block_motion.h>
#include <hybrid/dda/geometry/cell_grid.h>
#include <hybrid/dda/linear/frontal_lu.h>
#include <hybrid/dda/linear/linear_solver.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/dda/springs/spring_stiffness.h>
#include <hybrid/dda/step/memory_estimate.h>

#include <algorithm>
#include <omp.h>

namespace hybrid::dda
{
  namespace
  {
    /// Add the pairs of loose blocks that touch: a corner of one lies in the box of the other.
    void add_loose_pairs(const Model &model, std::vector<BlockMatrix::Pair> &pairs)
    {
      const Geometry  &g = model.initial;
      std::vector<Box> boxes;
      for (int b = 0; b < model.n_mass(); ++b)
        {
          const double margin = 1e-3 * model.blocks[b].size;
          Box          box{g.vertices[g.offset[b]], g.vertices[g.offset[b]]};
          for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
            {
              box.lower = box.lower.cwiseMin(g.vertices[v]);
              box.upper = box.upper.cwiseMax(g.vertices[v]);
            }
          boxes.push_back({box.lower - Vec2(margin, margin), box.upper + Vec2(margin, margin)});
        }
      CellGrid grid;
      grid.build(boxes);
      std::vector<int> found;
      for (int b = 0; b < model.n_mass(); ++b)
        for (int v = g.offset[b]; v < g.offset[b + 1] && !model.bonded[b]; ++v)
          {
            found.clear();
            grid.find(g.vertices[v], found);
            for (const int other : found)
              if (other != b)
                pairs.push_back({std::min(b, other), std::max(b, other)});
          }
    }



    /// Pairs of blocks with joints, or that touch and are loose, each once, the smaller number
    /// first.
    std::vector<BlockMatrix::Pair> block_pairs(const Model &model)
    {
      std::vector<BlockMatrix::Pair> pairs;
      for (const Joint &joint : model.joints)
        if (joint.other != foundation_body)
          pairs.push_back({std::min(joint.block, joint.other), std::max(joint.block, joint.other)});
      add_loose_pairs(model, pairs);
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
      return pairs;
    }



    /// Of a sparse factor with what it is made of. @param joined bytes of the copy with a
    /// foundation, of many blocks only until the factor is made
    SolverMemory memory_of_factor(const FrontTree &tree, const double pairs, const double joined)
    {
      const FrontPlan plan(tree, omp_get_max_threads() > 1 && is_worth_sharing(tree.n_blocks()));
      const double    n = tree.n_blocks(), per_mat6 = sizeof(Mat6);
      double          own = 0., later = 0.; // entries of the factor
      for (int f = 0; f < tree.n_fronts(); ++f)
        {
          own += static_cast<double>(tree.own(f)) * tree.own(f);
          later += static_cast<double>(tree.own(f)) * tree.later(f);
        }
      const auto work_of = [](const FrontPlan::Largest &largest) { // panel and inverse
        return (static_cast<double>(largest.panel) + 1.5 * largest.own * largest.own) *
               sizeof(Mat6);
      };
      const double work =
        work_of(plan.largest) +
        (plan.shared.empty() ? 0. : omp_get_max_threads() - 1.) * work_of(plan.largest_shared);
      const double n_later = static_cast<double>(tree.later_places.size());
      const double lists   = n_later * (2. * sizeof(int) + sizeof(Vec6)) +
                           n * (2. * sizeof(Vec6) + 10. * sizeof(int)) + 5. * pairs * sizeof(int);
      const double waits = static_cast<double>(plan.size) * sizeof(double);
      const double kept  = static_cast<double>(FrontalLu::kept_entries(tree)) * sizeof(double);
      const double passing =
        n < SparseFactor::many_blocks ? waits + work + joined : std::max(waits + work, joined);
      return {(own + later + n + pairs) * per_mat6 + passing + lists,
              (later + pairs) * per_mat6 + std::max(0., kept - waits)};
    }
  } // namespace



  SolverMemory estimated_memory(const Model &model, const bool moving_foundation)
  {
    const auto      pairs   = block_pairs(model);
    const double    n       = model.n_blocks();
    const double    touch   = static_cast<double>(pairs.size());
    const double    springs = 2. * static_cast<double>(model.joints.size());
    const double    corners = static_cast<double>(model.initial.vertices.size());
    const FrontTree tree(model.n_blocks(), pairs);
    const double    per_mat6 = sizeof(Mat6), per_vec6 = sizeof(Vec6), per_int = sizeof(int);

    // Forces and stiffness; joint, slots, lists of blocks, role and conditions.
    const double in_springs =
      springs * (sizeof(Springs::Spring) + sizeof(Springs::Bodies) + sizeof(Springs::Response) +
                 sizeof(Springs::Forces) + SpringStiffness::bytes_per_spring() + 5. * per_int + 6.);
    const double in_matrix = (n + 2. * touch) * per_mat6 + 6. * touch * per_int + 3. * n * per_int;
    // Masses, motions, and vectors of the step, of its updates and of the linear solver.
    constexpr double vectors = 20.;
    const double     in_vectors =
      n * (sizeof(BlockMass) + sizeof(BlockMotion) + vectors * per_vec6) + corners * sizeof(Vec2);
    // Grid and boxes with an entry in each of about six cells, near blocks, bonded pairs.
    constexpr double search    = 350.;
    const double     in_search = n * search;

    // The copy that sweeps read, with the inverse of the diagonal; else given back.
    const double in_sweeps =
      model.n_blocks() < LinearSolver::many_blocks ? (n + 2. * touch) * per_mat6 : 0.;

    // The copy that is factored with a foundation.
    const double in_joined = moving_foundation ? (n + 2. * touch) * per_mat6 : 0.;

    SolverMemory memory = memory_of_factor(tree, touch, in_joined);
    memory.bonded += in_springs + in_matrix + in_vectors + in_search + in_sweeps;
    return memory;
  }
} // namespace hybrid::dda
