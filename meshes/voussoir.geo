// Two rectangles of triangular blocks (alternating diagonals) beside each other, each with nodes of its own, between two vertical walls
// of a rigid base (the line ground), far above its floor: a beam with a crack at midspan. Midspan at x = 0, the lower side at y = 0 [m].

DefineConstant[
  span      = {10,  Min 0.001, Name "Span"},         // between the walls [m]
  thickness = {1,   Min 0.001, Name "Thickness"},    // [m]
  h         = {0.1, Min 0.001, Name "Resolution/h"}  // largest edge length along the sides [m]
];

columns = Ceil(span / 2 / h - 1e-9);
rows    = Ceil(thickness / h - 1e-9);

For k In {0:1}
  x0 = (k - 1) * span / 2;
  p  = newp;
  Point(p)     = {x0, 0, 0};
  Point(p + 1) = {x0 + span / 2, 0, 0};
  Point(p + 2) = {x0 + span / 2, thickness, 0};
  Point(p + 3) = {x0, thickness, 0};
  l = newl;
  For i In {0:3}
    Line(l + i) = {p + i, p + (i + 1) % 4};
  EndFor
  Transfinite Curve {l, l + 2} = columns + 1;
  Transfinite Curve {l + 1, l + 3} = rows + 1;
  loop = newll; Curve Loop(loop) = {l:l + 3};
  s = news; Plane Surface(s) = {loop};
  Transfinite Surface {s} AlternateRight;
  beam[]  += s;
  sides[] += {l:l + 3};
EndFor

p = newp;
Point(p)     = {-span / 2, 2 * thickness, 0};
Point(p + 1) = {-span / 2, -2 * thickness, 0};
Point(p + 2) = {span / 2, -2 * thickness, 0};
Point(p + 3) = {span / 2, 2 * thickness, 0};
l = newl;
For i In {0:2}
  Line(l + i) = {p + i, p + i + 1};
EndFor
Transfinite Curve {l:l + 2} = 2;

Physical Surface("sliding_mass") = {beam[]};
Physical Curve("mass_surface")   = {sides[]};
Physical Curve("ground")         = {l:l + 2};
