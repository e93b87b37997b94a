// A trapezoid on the ground (a ridge, Level > 0) or in it (a valley that is filled, Level < 0) over a rectangle of bedrock; its
// wide side is at y = 0. Structured quadrilaterals [m].

DefineConstant[
  level = {-40, Name "Level"},                          // of its narrow side
  wide  = {100, Min 0.001, Name "Wide"},                // half of the wide side
  small = {50,  Min 0.001, Name "Narrow"},              // half of the narrow side
  width = {400, Min 0.001, Name "Half width"},          // of the bedrock
  depth = {200, Min 0.001, Name "Depth"},               // of the base below y = 0
  h     = {20,  Min 0.001, Name "Resolution/h"},        // largest edge length, roughly
  fine  = {10,  Min 0.001, Name "Resolution/fill"}      // the same in the trapezoid
];

inner = level > 0 ? wide : small; // half width of the bedrock's middle part at its top
top   = level > 0 ? 0 : level;
x[]   = {-width, -inner, inner, width};
cells[] = {Ceil((width - wide) / h - 1e-9), Ceil(2 * wide / fine - 1e-9), Ceil((width - wide) / h - 1e-9)};
rows    = Ceil(depth / h - 1e-9);
layers  = Ceil(Fabs(level) / fine - 1e-9);

// ---- rectangles of bedrock
For i In {0:3}
  a = newp; Point(a) = {x[i], -depth, 0};  low[]  += a;
  b = newp; Point(b) = {x[i], top, 0};     high[] += b;
  l = newl; Line(l) = {a, b};              up[]   += l;
  Transfinite Curve {l} = rows + 1;
EndFor
For i In {0:2}
  a = newl; Line(a) = {low[i], low[i + 1]};    below[] += a;
  b = newl; Line(b) = {high[i], high[i + 1]};  above[] += b;
  Transfinite Curve {a, b} = cells[i] + 1;
  loop = newll; Curve Loop(loop) = {a, up[i + 1], -b, -up[i]};
  s = news; Plane Surface(s) = {loop};         rock[] += s;
EndFor
left[]  = {up[0]};
right[] = {up[3]};

// ---- the trapezoid, and bedrock beside a valley
u[] = {-width, -wide, wide, width};
If (level > 0)
  u[1] = -small;
  u[2] = small;
EndIf
first = level > 0 ? 1 : 0;
For i In {first:3 - first}
  p = newp; Point(p) = {u[i], level > 0 ? level : 0, 0};  crown[] += p;
  l = newl; Line(l) = {high[i], p};                       side[]  += l;
  Transfinite Curve {l} = layers + 1;
EndFor
For i In {first:2 - first}
  k = i - first;
  l = newl; Line(l) = {crown[k], crown[k + 1]};  cover[] += l;
  Transfinite Curve {l} = cells[i] + 1;
  loop = newll; Curve Loop(loop) = {above[i], side[k + 1], -l, -side[k]};
  s = news; Plane Surface(s) = {loop};
  If (i == 1)
    fill = s;
  Else
    rock[] += s;
  EndIf
EndFor
If (level > 0)
  ground[] = {above[0], side[0], cover[0], side[1], above[2]};
Else
  ground[] = cover[];
  left[]  += side[0];
  right[] += side[3];
EndIf

Transfinite Surface {rock[], fill};
Recombine Surface {rock[], fill};

Physical Surface("bedrock")      = {rock[]};
Physical Surface("bedrock_soft") = {fill};
Physical Curve("base")           = {below[]};
Physical Curve("left")           = {left[]};
Physical Curve("right")          = {right[]};
Physical Curve("ground")         = {ground[]};
