// Bar of square cells with equally spaced bedding planes across it [m]. It stands (along y, base below) or lies (along x,
// base on the left, ground on the right): rollers on the sides leave a P wave in the one and an S wave in the other.

DefineConstant[
  length  = {1000, Min 0.001, Name "Length"},      // of the bar [m]
  width   = {10,   Min 0.001, Name "Width"},       // [m]
  lying   = {0,    Choices{0, 1}, Name "Lying"},   // 0: along y, 1: along x
  planes  = {1,    Min 0, Max 20, Step 1, Name "Planes"}, // bedding_1 ... bedding_<n> from the base on
  first   = {300,  Min 0.001, Name "First plane"}, // distance of bedding_1 from the base [m]
  spacing = {20,   Min 0.001, Name "Spacing"},     // of the planes [m]
  h       = {10,   Min 0.001, Name "Resolution/h"} // largest edge length [m]
];

If (first + (planes - 1) * spacing >= length)
  Error("The last of %g planes, at First plane + (Planes - 1) Spacing = %g, must be below Length = %g", planes,
        first + (planes - 1) * spacing, length);
EndIf

level[] = {0};
For i In {1:planes}
  level[] += first + (i - 1) * spacing;
EndFor
level[] += length;

// ---- sections across the bar from the base on; a and b: its two ends
For i In {0:#level[] - 1}
  a = newp;
  If (lying)
    Point(a) = {level[i], width, 0};
  Else
    Point(a) = {0, level[i], 0};
  EndIf
  b = newp;
  If (lying)
    Point(b) = {level[i], 0, 0};
  Else
    Point(b) = {width, level[i], 0};
  EndIf
  l = newl; Line(l) = {a, b};
  Transfinite Curve {l} = Ceil(width / h - 1e-9) + 1;
  across[] += l;
  If (i > 0)
    la = newl; Line(la) = {last_a, a};
    lb = newl; Line(lb) = {last_b, b};
    Transfinite Curve {la, lb} = Ceil((level[i] - level[i - 1]) / h - 1e-9) + 1;
    loop = newll; Curve Loop(loop) = {across[i - 1], lb, -l, -la};
    s = news; Plane Surface(s) = {loop};
    Transfinite Surface {s};
    Recombine Surface {s};
    part[]   += s;
    side_a[] += la;
    side_b[] += lb;
  EndIf
  last_a = a;
  last_b = b;
EndFor

Physical Surface("bedrock") = {part[]};
Physical Curve("base")      = {across[0]};
Physical Curve("ground")    = {across[#across[] - 1]};
Physical Curve("left")      = {side_a[]};
Physical Curve("right")     = {side_b[]};
For i In {1:planes}
  Physical Curve(Sprintf("bedding_%g", i)) = {across[i]};
EndFor
