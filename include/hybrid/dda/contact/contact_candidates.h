// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/contact/bonded_outline.h>
#include <hybrid/dda/contact/contact_scope.h>
#include <hybrid/dda/contact/pair_tolerances.h>
#include <hybrid/dda/geometry/cell_grid.h>
#include <hybrid/dda/geometry/geometry.h>

#include <tuple>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  /// A vertex near a block (edge = -1: any edge of it), one edge of it, or one of a surface.
  struct ContactCandidate
  {
    int vertex_body; ///< block, or foundation_body
    int vertex;      ///< vertex or foundation node
    int edge_body;   ///< block, or foundation_body
    int edge;        ///< its first vertex or foundation node, or -1

    friend bool operator<(const ContactCandidate &a, const ContactCandidate &b)
    {
      return std::tie(a.vertex_body, a.vertex, a.edge_body, a.edge) <
             std::tie(b.vertex_body, b.vertex, b.edge_body, b.edge);
    }

    friend bool operator==(const ContactCandidate &a, const ContactCandidate &b)
    {
      return a.vertex_body == b.vertex_body && a.vertex == b.vertex && a.edge_body == b.edge_body &&
             a.edge == b.edge;
    }
  };


  /// An edge of a surface that a block of the mass is bonded to.
  struct BondedEdge
  {
    int block;
    int body; ///< foundation_body, or block of the bedrock
    int edge; ///< its first vertex or foundation node

    friend bool operator<(const BondedEdge &a, const BondedEdge &b)
    {
      return std::tie(a.block, a.body, a.edge) < std::tie(b.block, b.body, b.edge);
    }

    friend bool operator==(const BondedEdge &a, const BondedEdge &b)
    {
      return a.block == b.block && a.body == b.body && a.edge == b.edge;
    }
  };


  /// Pairs of bodies that are no candidates. Empty lists skip nothing.
  struct SkippedPairs
  {
    std::vector<std::pair<int, int>>
      bonded; ///< blocks of the mass with an unreleased joint between them: never candidates, but
              ///< for those with joint_edges
    std::vector<BondedEdge>   surface; ///< with an unreleased joint: never candidates
    std::vector<ContactScope> scope;   ///< per block; empty: all look at everything
    std::vector<char> held_off{}; ///< per block: does not look at a surface unless awake to all;
                                  ///< empty: none
    BondedOutline outline{};      ///< of bonds between blocks of the mass that have not yielded
    std::vector<BondedEdge> joint_edges{}; ///< of blocks that may touch beside the joint between
                                           ///< them, which has yielded: along these it acts alone
  };


  /**
   * All (vertex, body) pairs closer than their search distance, kept in a Verlet list.
   *
   * The list holds pairs closer than distance + margin and is good until some
   * point has moved by margin / 2, less what all points have moved together (an
   * earthquake carries the whole mass along). With each pair goes its distance d
   * when the list was built: while no point has moved by more than m, it is at
   * least d - 2 m, so a pair with d - 2 m above the distance is asleep: no
   * contact can arise there. Pairs of one block with itself are left out, and
   *   - bonded pairs of blocks: their joint carries the load (of blocks that are not convex, which
   *     may touch elsewhere, only the edges along which it lies, once it has yielded);
   *   - blocks that joints hold beside each other (held_neighbours.h), unless one of them is
   *     awake: an intact mass has thousands of these, all at distance zero;
   *   - edges (and their ends) of a surface to which a block is bonded;
   *   - a block that is held off (bonded to the surface, or touching it with corners
   *     only while its neighbours hold it) with the whole surface, until it is awake to all.
   *     A belt slides over the bends of a foundation of straight segments, where corners would
   *     catch: it wakes a block to the surface once that has slid 1/400 of the belt joint's length
   *     deep into a segment that rises (joint_failure.h). A block that touches it with a corner
   *     only is woken: it may be squeezed into it.
   * Surfaces are the foundation and the outline of bedrock made of blocks (BedrockSurface); they
   * never meet each other. Every place of a surface is a vertex, as it may bend.
   *
   * Candidates are sorted by vertex_body, vertex, edge_body, edge, so results
   * do not depend on when the list was built.
   */
  class ContactCandidates
  {
  public:
    /// @param pairs within whose search distance none may be missed; must outlive this.
    /// @param margin [m] of the Verlet list.
    ContactCandidates(const PairTolerances &pairs, double margin);

    /// Blocks that joints hold beside each other, as compressed rows; the row of block b is
    /// list[offset[b]] .. list[offset[b + 1] - 1]. The relation is symmetric.
    void set_neighbours(const std::vector<int> &offset, const std::vector<int> &list);

    /// The list is built again at the next update() only if @p skipped differs from the last one.
    void set_skipped_pairs(const SkippedPairs &skipped);

    const BondedOutline &outline() const
    {
      return skipped.outline;
    }

    /// Pairs that are in the list, awake, however far they are, sorted: contacts that lie deep
    /// behind an edge of an outline that lists its edges one by one.
    void keep_awake(const std::vector<ContactCandidate> &held);

    /// Edges of this body are near a vertex one by one: of a surface, or of a large outline.
    static bool lists_edges(const Geometry &geometry, int body);

    /// Build the list if it is no longer good. Returns true if it was built.
    bool update(const Geometry &geometry);

    /// @param awake_then per block: at the search before; empty: all looked at everything.
    void set_was_awake(const std::vector<ContactScope> &awake_then)
    {
      was_awake.assign(awake_then.begin(), awake_then.end());
    }

    /// For a pair of the list: true if neighbours of the mesh, or a block that was held off and a
    /// surface, look at each other for the first time.
    bool is_first_activation(int body, int other) const;

    /// A joint acts along this edge of @p body with @p block, not contacts.
    bool is_joint_edge(int block, int body, int edge) const;

    /// Pairs of the list that are not asleep, sorted: all that are within the distance, and some
    /// more.
    const std::vector<ContactCandidate> &awake() const
    {
      return awake_pairs;
    }

    /// Pairs of the list, awake or asleep.
    const std::vector<ContactCandidate> &all() const
    {
      return candidates;
    }

    /// Have all pairs in the list that can meet while the points move from @p geometry to these
    /// places. @param way no point moves farther, beside what all move [m]. @return true if the
    /// list was built
    bool list_for(const Geometry          &geometry,
                  const std::vector<Vec2> &vertices,
                  const std::vector<Vec2> &nodes,
                  double                   way);

    /// Distances computed by the last build.
    long n_distance_tests() const
    {
      return distance_tests;
    }

  private:
    /// Largest movement of a point to these places since the list was built, less the movement of
    /// all [m].
    double movement(const std::vector<Vec2> &vertices, const std::vector<Vec2> &nodes) const;

    /// @param wide skin of the list [m], at least the margin
    void build(const Geometry &geometry, double wide);

    void list_boxes(const Geometry &geometry);

    void add_candidates(const Geometry &geometry, int body, int vertex);

    void add_edge_of_surface(const Geometry &geometry, int block, int vertex, int number);

    void add_block(const Geometry &geometry, int body, int vertex, int block);

    /// The edges of a large outline near @p point, or @p any_edge if it is deep inside.
    void
    add_near_edges(const Geometry &geometry, const ContactCandidate &any_edge, const Vec2 &point);

    void add(const ContactCandidate &pair, double apart);

    /// What is kept awake, however far it is.
    void add_kept();

    double search_distance(const ContactCandidate &pair) const
    {
      return pairs.of(pair.vertex_body, pair.edge_body).search_distance();
    }

    void wake(double moved);

    bool are_neighbours(int block, int other) const;

    bool is_skipped_pair(int block, int other) const;

    bool is_skipped_edge(const BondedEdge &pair) const;

    bool is_held_off(int block) const;

    const PairTolerances &pairs;
    const double          margin;
    double                skin; ///< of the list: the margin, or wider for a step that moves far [m]

    std::vector<int>          neighbour_offset, neighbours; ///< rows sorted
    SkippedPairs              skipped;                      ///< as given
    SkippedPairs              lookup;                       ///< pairs sorted, blocks in both orders
    std::vector<ContactScope> was_awake;                    ///< per block; empty: all
    bool                      is_outdated = true;

    std::vector<ContactCandidate> candidates, awake_pairs, kept_awake;
    std::vector<double>           apart_when_built; ///< per candidate [m]; 0 inside the body
    double            awake_for = -1.; ///< movement for which the awake pairs were chosen [m]
    std::vector<Vec2> built_vertices, built_nodes; ///< positions at the last build [m]
    CellGrid          grid;
    std::vector<Box>
      boxes; ///< of bodies: foundation segments, blocks of the mass, edges of bedrock
    std::vector<std::pair<int, int>> bodies;            ///< body and edge (-1: any) of each box
    int                              first_bedrock = 0; ///< BedrockSurface::first_block
    std::vector<int>                 found;
    long                             distance_tests = 0;
  };
} // namespace hybrid::dda
