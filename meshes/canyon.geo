// Semicircular canyon in flat ground, its centre at the origin, ground at y = 0, rock below [m]. Structured quadrilaterals: a
// ring of four blocks around the canyon out to a rectangle, and six rectangles around that.

DefineConstant[
  radius = {100, Min 0.001, Name "Radius"},        // a of the canyon [m]
  width  = {600, Min 0.001, Name "Half width"},    // from the middle to a side [m]
  depth  = {400, Min 0.001, Name "Depth"},         // of the base below the ground [m]
  h      = {50,  Min 0.001, Name "Resolution/h"},  // largest edge length away from the canyon [m]
  fine   = {20,  Min 0.001, Name "Resolution/canyon"} // largest edge length along the canyon [m]
];

inner = 2 * radius; // half width and depth of the rectangle
If (width <= inner || depth <= inner)
  Error("Half width = %g and Depth = %g must be more than twice Radius = %g", width, depth, radius);
EndIf

eighth  = Ceil(Pi / 4 * radius / fine - 1e-9); // cells along an eighth of the circle
whole   = Ceil(inner / h - 1e-9);
side    = eighth > whole ? eighth : whole;     // ... and along the piece of the rectangle that is opposite
across  = Ceil((inner - radius) * 1.5 / h - 1e-9); // the ring
beside  = Ceil((width - inner) / h - 1e-9);
beneath = Ceil((depth - inner) / h - 1e-9);

// ---- points of the canyon, of the rectangle and of the model, from the left rim around to the right one
c = newp; Point(c) = {0, 0, 0};
x[] = {-1, -Sqrt(0.5), 0, Sqrt(0.5), 1};
y[] = {0, -Sqrt(0.5), -1, -Sqrt(0.5), 0};
u[] = {-1, -1, 0, 1, 1};
v[] = {0, -1, -1, -1, 0};
For i In {0:4}
  p = newp; Point(p) = {radius * x[i], radius * y[i], 0};  near[] += p;
  p = newp; Point(p) = {inner * u[i], inner * v[i], 0};    far[]  += p;
  l = newl; Line(l) = {near[i], far[i]};                   spoke[] += l;
  Transfinite Curve {l} = across + 1;
EndFor
For i In {0:3}
  l = newl; Circle(l) = {near[i], c, near[i + 1]}; arc[] += l;
  m = newl; Line(m) = {far[i], far[i + 1]};        frame[] += m;
  Transfinite Curve {l, m} = side + 1;
  loop = newll; Curve Loop(loop) = {spoke[i], m, -spoke[i + 1], -l};
  s = news; Plane Surface(s) = {loop};
  part[] += s;
EndFor

// ---- left and right of the rectangle
For i In {0:1}
  sign = 2 * i - 1;
  top = newp; Point(top) = {sign * width, 0, 0};
  low = newp; Point(low) = {sign * width, -inner, 0};
  bottom = newp; Point(bottom) = {sign * width, -depth, 0};
  below = newp; Point(below) = {sign * inner, -depth, 0};
  t = newl; Line(t) = {far[4 * i], top};
  e = newl; Line(e) = {top, low};
  m = newl; Line(m) = {far[1 + 2 * i], low};
  f = newl; Line(f) = {low, bottom};
  b = newl; Line(b) = {bottom, below};
  d = newl; Line(d) = {below, far[1 + 2 * i]};
  Transfinite Curve {t, m, b} = beside + 1;
  Transfinite Curve {e} = side + 1;
  Transfinite Curve {f, d} = beneath + 1;
  loop = newll;
  If (i == 0)
    Curve Loop(loop) = {t, e, -m, -frame[0]};
  Else
    Curve Loop(loop) = {t, e, -m, frame[3]};
  EndIf
  s = news; Plane Surface(s) = {loop};  part[] += s;
  loop = newll; Curve Loop(loop) = {m, f, b, d};
  s = news; Plane Surface(s) = {loop};  part[] += s;
  ground[] += t;  edge[] += {e, f};  base[] += b;  down[] += d;  under[] += below;
EndFor

// ---- below it
middle = newp; Point(middle) = {0, -depth, 0};
axis = newl; Line(axis) = {middle, far[2]};
Transfinite Curve {axis} = beneath + 1;
For i In {0:1}
  b = newl; Line(b) = {under[i], middle};
  Transfinite Curve {b} = side + 1;
  loop = newll;
  If (i == 0)
    Curve Loop(loop) = {b, axis, -frame[1], -down[0]};
  Else
    Curve Loop(loop) = {b, axis, frame[2], -down[1]};
  EndIf
  s = news; Plane Surface(s) = {loop};  part[] += s;
  base[] += b;
EndFor

Transfinite Surface {part[]};
Recombine Surface {part[]};

Physical Surface("bedrock") = {part[]};
Physical Curve("base")      = {base[]};
Physical Curve("left")      = {edge[0], edge[1]};
Physical Curve("right")     = {edge[2], edge[3]};
Physical Curve("ground")    = {ground[], arc[], spoke[0], spoke[4]};
