// Column whose lower part is bedrock (structured quadrilaterals) and whose upper part is blocks (structured
// triangles with alternating diagonals); base at y = 0, left side at x = 0 [m].

DefineConstant[
  width  = {10,  Min 0.001, Name "Width"},         // [m]
  height = {100, Min 0.001, Name "Height"},        // of the whole column [m]
  block  = {50,  Min 0.001, Name "Block height"},  // of the upper part [m]
  h      = {5,   Min 0.001, Name "Resolution/h"}   // largest edge length along the sides [m]
];

If (block <= 0 || block >= height)
  Error("Block height = %g must be between 0 and Height = %g", block, height);
EndIf

level[] = {0, height - block, height};
columns = Ceil(width / h - 1e-9);
For i In {0:2}
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
    Transfinite Surface {s} AlternateRight;
    part[]  += s;
    left[]  += ll;
    right[] += lr;
  EndIf
  below_a = a;
  below_b = b;
EndFor
Recombine Surface {part[0]};

Physical Surface("bedrock")       = {part[0]};
Physical Surface("sliding_mass")  = {part[1]};
Physical Curve("base")            = {across[0]};
Physical Curve("sliding_surface") = {across[1]};
Physical Curve("mass_surface")    = {left[1], across[2], right[1]};
Physical Curve("left")            = {left[0]};
Physical Curve("right")           = {right[0]};
