// Rectangle of triangular blocks (alternating diagonals) on a straight rigid base, the line sliding_surface, which
// the line ground continues on both sides. The lower left corner is at the origin; the base rises to the right at the
// angle; 90 degrees is a wall, with the blocks on its left [m].

DefineConstant[
  angle  = {0,  Min -90, Max 90, Name "Angle"},   // of the base [deg]
  width  = {10, Min 0.001, Name "Width"},         // along the base [m]
  height = {10, Min 0.001, Name "Height"},        // away from the base [m]
  beyond = {10, Min 0.001, Name "Base beyond"},   // length of the base on either side [m]
  h      = {1,  Min 0.001, Name "Resolution/h"}   // largest edge length along the sides [m]
];

c = Cos(angle * Pi / 180);
s = Sin(angle * Pi / 180);
columns = Ceil(width / h - 1e-9);
rows    = Ceil(height / h - 1e-9);

Point(1) = {0, 0, 0};
Point(2) = {c * width, s * width, 0};
Point(3) = {c * width - s * height, s * width + c * height, 0};
Point(4) = {-s * height, c * height, 0};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Transfinite Curve {1, 3} = columns + 1;
Transfinite Curve {2, 4} = rows + 1;
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Surface {1} AlternateRight;

Point(5) = {-c * beyond, -s * beyond, 0};
Point(6) = {c * (width + beyond), s * (width + beyond), 0};
Line(5) = {5, 1};
Line(6) = {2, 6};
Transfinite Curve {5, 6} = 2;

Physical Surface("sliding_mass")    = {1};
Physical Curve("sliding_surface")   = {1};
Physical Curve("mass_surface")      = {2, 3, 4};
Physical Curve("ground")            = {5, 6};
