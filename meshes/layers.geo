// Horizontal layers of structured quadrilaterals, base at y = 0, left side at x = 0 [m]; every layer is a surface,
// the planes between them are bedding_1 (top) to bedding_2.

DefineConstant[
  width  = {100, Min 0.001, Name "Width"},            // [m]
  bottom = {10,  Min 0.001, Name "Base height"},      // of the lowest layer [m]
  middle = {5,   Min 0.001, Name "Middle height"},    // of the layer between the planes [m]
  top    = {5,   Min 0.001, Name "Top height"},       // of the highest layer [m]
  h      = {5,   Min 0.001, Name "Resolution/h"}      // largest edge length [m]
];

level[]  = {0, bottom, bottom + middle, bottom + middle + top};
columns  = Ceil(width / h - 1e-9);
For i In {0:3}
  a = newp; Point(a) = {0, level[i], 0};
  b = newp; Point(b) = {width, level[i], 0};
  l = newl; Line(l) = {a, b};
  Transfinite Curve {l} = columns + 1;
  across[] += l;
  If (i > 0)
    rows = Ceil((level[i] - level[i - 1]) / h - 1e-9);
    ll = newl; Line(ll) = {below_a, a};
    lr = newl; Line(lr) = {below_b, b};
    Transfinite Curve {ll, lr} = rows + 1;
    loop = newll; Curve Loop(loop) = {across[i - 1], lr, -l, -ll};
    s = news; Plane Surface(s) = {loop};
    Transfinite Surface {s};
    Recombine Surface {s};
    part[]  += s;
    left[]  += ll;
    right[] += lr;
  EndIf
  below_a = a;
  below_b = b;
EndFor

Physical Surface("bedrock")  = {part[]};
Physical Curve("base")       = {across[0]};
Physical Curve("bedding_2")  = {across[1]};
Physical Curve("bedding_1")  = {across[2]};
Physical Curve("ground")     = {across[3]};
Physical Curve("left")       = {left[]};
Physical Curve("right")      = {right[]};
