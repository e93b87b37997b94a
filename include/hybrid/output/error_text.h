// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/end_text.h>

namespace hybrid::output
{
  /// The line on the error of the time step, with what half the step costs on the screen only.
  EndText error_text(const Summary &summary);

  /// The line on the error of the mesh of blocks, the same way.
  EndText mesh_error_text(const Summary::MeshError &error);

  /// The line on what a finer mesh of the bedrock would change, by the run itself; nothing if runs
  /// with coarser ones tell it.
  std::string bedrock_mesh_text(const Summary &summary);

  /// The line on who finds the error of a mesh of blocks, which one run does not tell.
  std::string block_mesh_text(const Summary &summary, const std::string &directory);
} // namespace hybrid::output
