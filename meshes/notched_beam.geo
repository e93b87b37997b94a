// Beam of triangular blocks (alternating diagonals) with a notch from below at midspan, on two narrow flat supports of a rigid base (the line
// ground). Midspan at x = 0, the lower side at y = 0 [m].

DefineConstant[
  depth     = {0.5,   Min 0.001, Name "Depth"},        // [m]
  span      = {1.5,   Min 0.001, Name "Span"},         // between the middles of the supports [m]
  over      = {0.125, Min 0.001, Name "Overhang"},     // beyond the supports, on either side [m]
  support   = {0.03,  Min 0.001, Name "Support"},      // width of a support [m]
  notch     = {0.125, Min 0.001, Name "Notch"},        // depth of the notch [m]
  h         = {0.03125, Min 0.001, Name "Resolution/h"} // largest edge length along the sides [m]
];

half    = span / 2 + over;
columns = Ceil(half / h - 1e-9);
below   = Ceil(notch / h - 1e-9);
above   = Ceil((depth - notch) / h - 1e-9);

// The halves share the ligament from the notch's tip (1) to the top (2); the faces of the notch have ends of their own.
Point(1) = {0, notch, 0};
Point(2) = {0, depth, 0};
Line(1)  = {1, 2};
Transfinite Curve {1} = above + 1;
For k In {0:1}
  side = 2 * k - 1;
  p = newp;
  Point(p)     = {0, 0, 0};
  Point(p + 1) = {side * half, 0, 0};
  Point(p + 2) = {side * half, notch, 0};
  Point(p + 3) = {side * half, depth, 0};
  l = newl;
  Line(l)     = {p, 1};        // face of the notch
  Line(l + 1) = {p, p + 1};
  Line(l + 2) = {p + 1, p + 2};
  Line(l + 3) = {1, p + 2};
  Line(l + 4) = {p + 2, p + 3};
  Line(l + 5) = {2, p + 3};
  Transfinite Curve {l, l + 2} = below + 1;
  Transfinite Curve {l + 4} = above + 1;
  Transfinite Curve {l + 1, l + 3, l + 5} = columns + 1;
  If (k == 1)
    a = newll; Curve Loop(a) = {l + 1, l + 2, -(l + 3), -l};
    b = newll; Curve Loop(b) = {l + 3, l + 4, -(l + 5), -1};
  Else
    a = newll; Curve Loop(a) = {l, l + 3, -(l + 2), -(l + 1)};
    b = newll; Curve Loop(b) = {1, l + 5, -(l + 4), -(l + 3)};
  EndIf
  s = news; Plane Surface(s) = {a};
  t = news; Plane Surface(t) = {b};
  Transfinite Surface {s, t} AlternateRight;
  beam[]  += {s, t};
  faces[] += {l, l + 1, l + 2, l + 4, l + 5};
EndFor

p = newp;
w = support / 2;
Point(p)     = {-span / 2 - w - 2 * over, -depth, 0};
Point(p + 1) = {-span / 2 - w, -depth, 0};
Point(p + 2) = {-span / 2 - w, 0, 0};
Point(p + 3) = {-span / 2 + w, 0, 0};
Point(p + 4) = {-span / 2 + w, -depth, 0};
Point(p + 5) = {span / 2 - w, -depth, 0};
Point(p + 6) = {span / 2 - w, 0, 0};
Point(p + 7) = {span / 2 + w, 0, 0};
Point(p + 8) = {span / 2 + w, -depth, 0};
Point(p + 9) = {span / 2 + w + 2 * over, -depth, 0};
l = newl;
For i In {0:8}
  Line(l + i) = {p + i, p + i + 1};
EndFor
Transfinite Curve {l:l + 8} = 2;
Physical Surface("sliding_mass") = {beam[]};
Physical Curve("mass_surface")   = {faces[]};
Physical Curve("ground")         = {l:l + 8};
