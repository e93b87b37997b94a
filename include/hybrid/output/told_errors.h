// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/summary.h>
#include <hybrid/restart/archive_forward.h>

#include <optional>
#include <string>

namespace hybrid::output
{
  /// What further runs have told of the errors of a run, kept for the run that is resumed after its
  /// end.
  struct ToldErrors
  {
    /// What they were asked for: other than this, nothing is known.
    struct Asked
    {
      long   steps       = 0;     ///< that the run took
      double end_time    = 0.;    ///< it came to [s]
      double second_step = 0.;    ///< of the second run [s]; 0: none was called for
      bool   of_mesh     = false; ///< coarser meshes were called for
    };

    Asked                  asked;
    Summary::ProbableError step;
    Summary::MeshError     mesh;
  };


  bool operator==(const ToldErrors::Asked &one, const ToldErrors::Asked &other);

  void serialize(restart::Archive &archive, Summary::ErrorPart &part);
  void serialize(restart::Archive &archive, Summary::ProbableError &error);
  void serialize(restart::Archive &archive, Summary::MeshError &error);
  void serialize(restart::Archive &archive, ToldErrors::Asked &asked);
  void serialize(restart::Archive &archive, ToldErrors &told);

  /// Safe from a kill. @throws WriteError.
  void write_told_errors(const std::string &file_name, const ToldErrors &told);

  /// Nothing if there is no file, or one that is damaged or another program's.
  std::optional<ToldErrors> read_told_errors(const std::string &file_name);
} // namespace hybrid::output
