// Step between two levels of flat ground: toe of the slope at the origin, lower ground to the right at y = 0, upper ground to the
// left at y = Height [m]. Structured quadrilaterals: a parallelogram above y = 0, two rectangles below.

DefineConstant[
  height = {50,  Min 0.001, Name "Height"},              // of the step [m]
  angle  = {60,  Min 1, Max 90, Name "Angle"},           // of the slope from the horizontal [deg]
  width  = {800, Min 0.001, Name "Half width"},          // from the toe to a side [m]
  depth  = {500, Min 0.001, Name "Depth"},               // of the base below the lower ground [m]
  h      = {40,  Min 0.001, Name "Resolution/h"},        // largest edge length [m]
  fine   = {25,  Min 0.001, Name "Resolution/step"}      // largest edge length up the step [m]
];

run = angle == 90 ? 0 : height / Tan(angle * Pi / 180);
If (run >= width)
  Error("Half width = %g must be more than Height / tan Angle = %g", width, run);
EndIf

columns = Ceil(width / h - 1e-9);
rows    = Ceil(depth / h - 1e-9);
steps   = Ceil(height / fine - 1e-9);

p[] = {};
x[] = {-width, 0, width, -width, 0, width, -width, -run};
y[] = {-depth, -depth, -depth, 0, 0, 0, height, height};
For i In {0:7}
  p[i] = newp; Point(p[i]) = {x[i], y[i], 0};
EndFor

// ---- lines along x at three levels, then lines upwards
b1 = newl; Line(b1) = {p[0], p[1]};
b2 = newl; Line(b2) = {p[1], p[2]};
m1 = newl; Line(m1) = {p[3], p[4]};
m2 = newl; Line(m2) = {p[4], p[5]};
t1 = newl; Line(t1) = {p[6], p[7]};
Transfinite Curve {b1, b2, m1, m2, t1} = columns + 1;
l1 = newl; Line(l1) = {p[0], p[3]};
l2 = newl; Line(l2) = {p[1], p[4]};
l3 = newl; Line(l3) = {p[2], p[5]};
Transfinite Curve {l1, l2, l3} = rows + 1;
u1 = newl; Line(u1) = {p[3], p[6]};
u2 = newl; Line(u2) = {p[4], p[7]};
Transfinite Curve {u1, u2} = steps + 1;

Curve Loop(101) = {b1, l2, -m1, -l1};  Plane Surface(101) = {101};
Curve Loop(102) = {b2, l3, -m2, -l2};  Plane Surface(102) = {102};
Curve Loop(103) = {m1, u2, -t1, -u1};  Plane Surface(103) = {103};
Transfinite Surface {101, 102, 103};
Recombine Surface {101, 102, 103};

Physical Surface("bedrock") = {101, 102, 103};
Physical Curve("base")      = {b1, b2};
Physical Curve("left")      = {l1, u1};
Physical Curve("right")     = {l3};
Physical Curve("ground")    = {t1, u2, m2};
