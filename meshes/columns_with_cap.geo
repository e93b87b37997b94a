// Three columns of square blocks that do not touch each other, the outer ones on higher ground of a rigid base, and a
// cap of rectangular blocks on all of them. The foot of the middle column is at y = 0, the left side at x = 0 [m].

DefineConstant[
  width   = {1,   Min 0.001, Name "Width"},          // of a column, and height of its blocks [m]
  gap     = {0.5, Min 0.001, Name "Gap"},            // between columns [m]
  outer   = {4,   Min 1,     Name "Outer blocks"},   // in an outer column
  middle  = {9,   Min 1,     Name "Middle blocks"},  // in the middle column; more than in an outer one
  cap     = {1,   Min 0.001, Name "Cap height"}      // [m]
];

x[] = {0, width, width + gap, 2 * width + gap, 2 * width + 2 * gap, 3 * width + 2 * gap};
number[] = {outer, middle, outer};
top = middle * width;

// ---- the cap: one row, a block on each column and each gap
For i In {0:5}
  p = newp; Point(p) = {x[i], top, 0};
  low[] += p;
  p = newp; Point(p) = {x[i], top + cap, 0};
  high[] += p;
  l = newl; Line(l) = {low[i], high[i]};
  upright[] += l;
EndFor
For i In {0:4}
  l = newl; Line(l) = {low[i], low[i + 1]};
  below[] += l;
  m = newl; Line(m) = {high[i], high[i + 1]};
  above[] += m;
  loop = newll; Curve Loop(loop) = {l, upright[i + 1], -m, -upright[i]};
  s = news; Plane Surface(s) = {loop};
  mass[] += s;
EndFor
Transfinite Curve {upright[], below[], above[]} = 2;

// ---- the columns
For i In {0:2}
  y = top - number[i] * width;
  p = newp; Point(p) = {x[2 * i], y, 0};
  q = newp; Point(q) = {x[2 * i + 1], y, 0};
  foot[] += {p, q};
  l = newl; Line(l) = {p, q};
  r = newl; Line(r) = {q, low[2 * i + 1]};
  k = newl; Line(k) = {p, low[2 * i]};
  feet[] += l;
  sides[] += {r, k};
  Transfinite Curve {l} = 2;
  Transfinite Curve {r, k} = number[i] + 1;
  loop = newll; Curve Loop(loop) = {l, r, -below[2 * i], -k};
  s = news; Plane Surface(s) = {loop};
  mass[] += s;
EndFor
Transfinite Surface {mass[]};
Recombine Surface {mass[]};

// ---- the ground beside the feet, with a step in the middle of each gap
step = top - outer * width;
Point(1001) = {-2 * width, step, 0};
Point(1002) = {width + gap / 2, step, 0};
Point(1003) = {width + gap / 2, 0, 0};
Point(1004) = {2 * width + 3 * gap / 2, 0, 0};
Point(1005) = {2 * width + 3 * gap / 2, step, 0};
Point(1006) = {5 * width + 2 * gap, step, 0};
path[] = {1001, foot[0], foot[1], 1002, 1003, foot[2], foot[3], 1004, 1005, foot[4], foot[5], 1006};
For i In {0:10}
  If (i != 1 && i != 5 && i != 9)
    l = newl; Line(l) = {path[i], path[i + 1]};
    ground[] += l;
  EndIf
EndFor
Transfinite Curve {ground[]} = 2;

Physical Surface("sliding_mass")  = {mass[]};
Physical Curve("sliding_surface") = {feet[]};
Physical Curve("ground")          = {ground[]};
