// Flat ground of bedrock (structured quadrilaterals) with a rectangular pit full of blocks (structured triangles with
// alternating diagonals); surface at y = 0, left side at x = 0 [m].

DefineConstant[
  pit_width = {10, Min 0.001, Name "Pit width"}, // [m]
  pit_depth = {20, Min 0.001, Name "Pit depth"}, // [m]
  margin    = {10, Min 0.001, Name "Margin"},    // rock left and right of the pit [m]
  below     = {30, Min 0.001, Name "Rock below"}, // the pit [m]
  h         = {1,  Min 0.001, Name "Resolution/h"}, // largest edge length in the pit and along it [m]
  far       = {4,  Min 0.001, Name "Resolution/far"} // largest other edge length of the rock [m]
];

x[] = {0, margin, margin + pit_width, 2 * margin + pit_width};
y[] = {-pit_depth - below, -pit_depth, 0};
cells_x[] = {Ceil(margin / far - 1e-9), Ceil(pit_width / h - 1e-9), Ceil(margin / far - 1e-9)};
cells_y[] = {Ceil(below / far - 1e-9), Ceil(pit_depth / h - 1e-9)};

// ---- a grid of 3 x 2 rectangles: across[3 j + i] below rectangle (i, j), up[4 j + i] to its left
For j In {0:2}
  For i In {0:3}
    p = newp; Point(p) = {x[i], y[j], 0};
    point[] += p;
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    l = newl; Line(l) = {point[4 * j + i], point[4 * j + i + 1]};
    Transfinite Curve {l} = cells_x[i] + 1;
    across[] += l;
  EndFor
EndFor
For j In {0:1}
  For i In {0:3}
    l = newl; Line(l) = {point[4 * j + i], point[4 * j + 4 + i]};
    Transfinite Curve {l} = cells_y[j] + 1;
    up[] += l;
  EndFor
EndFor
For j In {0:1}
  For i In {0:2}
    loop = newll; Curve Loop(loop) = {across[3 * j + i], up[4 * j + i + 1], -across[3 * j + 3 + i], -up[4 * j + i]};
    s = news; Plane Surface(s) = {loop};
    If (i == 1 && j == 1)
      Transfinite Surface {s} AlternateRight;
      pit = s;
    Else
      Transfinite Surface {s};
      Recombine Surface {s};
      rock[] += s;
    EndIf
  EndFor
EndFor

Physical Surface("bedrock")       = {rock[]};
Physical Surface("sliding_mass")  = {pit};
Physical Curve("base")            = {across[0], across[1], across[2]};
Physical Curve("sliding_surface") = {up[5], across[4], up[6]};
Physical Curve("mass_surface")    = {across[7]};
Physical Curve("ground")          = {across[6], across[8]};
Physical Curve("left")            = {up[0], up[4]};
Physical Curve("right")           = {up[3], up[7]};
