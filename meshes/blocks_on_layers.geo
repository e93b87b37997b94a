// Two layers of bedrock (structured quadrilaterals), the bedding plane bedding_1 between them (bedding_2 upright in the lower one), and a layer of blocks
// (structured triangles with alternating diagonals) on top; base at y = 0, left side at x = 0 [m].

DefineConstant[
  width = {20,  Min 0.001, Name "Width"},         // [m]
  lower = {10,  Min 0.001, Name "Lower height"},  // of the lower layer of rock [m]
  upper = {5,   Min 0.001, Name "Upper height"},  // of the upper layer of rock [m]
  block = {5,   Min 0.001, Name "Block height"},  // of the blocks [m]
  inset = {5,   Min 0.001, Name "Inset"},         // of the blocks from both sides [m]
  h     = {2.5, Min 0.001, Name "Resolution/h"}   // largest edge length [m]
];

If (2 * inset >= width)
  Error("Inset = %g must be less than half of Width = %g", inset, width);
EndIf

x[]     = {0, inset, width - inset, width};
level[] = {0, lower, lower + upper, lower + upper + block};
For i In {0:3}
  For k In {0:3}
    p[4 * i + k] = newp; Point(p[4 * i + k]) = {x[k], level[i], 0};
  EndFor
  For k In {0:2}
    a[3 * i + k] = newl; Line(a[3 * i + k]) = {p[4 * i + k], p[4 * i + k + 1]};
    Transfinite Curve {a[3 * i + k]} = Ceil((x[k + 1] - x[k]) / h - 1e-9) + 1;
  EndFor
EndFor
For i In {0:2}
  For k In {0:3}
    u[4 * i + k] = newl; Line(u[4 * i + k]) = {p[4 * i + k], p[4 * i + k + 4]};
    Transfinite Curve {u[4 * i + k]} = Ceil((level[i + 1] - level[i]) / h - 1e-9) + 1;
  EndFor
  For k In {0:2}
    If (i < 2 || k == 1)
      loop = newll; Curve Loop(loop) = {a[3 * i + k], u[4 * i + k + 1], -a[3 * i + k + 3], -u[4 * i + k]};
      s = news; Plane Surface(s) = {loop};
      Transfinite Surface {s} AlternateRight;
      If (i < 2)
        Recombine Surface {s};
        rock[] += s;
      Else
        mass[] += s;
      EndIf
    EndIf
  EndFor
EndFor

Physical Surface("bedrock")       = {rock[]};
Physical Surface("sliding_mass")  = {mass[]};
Physical Curve("base")            = {a[0], a[1], a[2]};
Physical Curve("bedding_1")       = {a[3], a[4], a[5]};
Physical Curve("bedding_2")       = {u[1]}; // upright, in the lower layer
Physical Curve("sliding_surface") = {a[7]};
Physical Curve("ground")          = {a[6], a[8]};
Physical Curve("mass_surface")    = {u[9], a[10], u[10]};
Physical Curve("left")            = {u[0], u[4]};
Physical Curve("right")           = {u[3], u[7]};
