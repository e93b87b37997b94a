// Disc of triangular blocks for a Brazilian test, centre at the origin. Two opposite arcs of the half angle carry the
// load. Edges of blocks run along the vertical diameter, where the disc is to split [m].

DefineConstant[
  d     = {1,  Min 0.001, Name "Diameter"},
  angle = {7.5, Min 1, Max 45, Name "Half angle"},   // of each loaded arc [deg]
  h     = {0.05, Min 0.0001, Name "Resolution/h"}   // edge length
];

r = d / 2;
a = angle * Pi / 180;
Point(1) = {0, 0, 0, h};
Point(2) = {r * Sin(a), r * Cos(a), 0, h};
Point(3) = {0, r, 0, h};
Point(4) = {-r * Sin(a), r * Cos(a), 0, h};
Point(5) = {-r * Sin(a), -r * Cos(a), 0, h};
Point(6) = {0, -r, 0, h};
Point(7) = {r * Sin(a), -r * Cos(a), 0, h};
Point(8) = {r, 0, 0, h};
Point(9) = {-r, 0, 0, h};

Circle(1) = {8, 1, 2};
Circle(2) = {2, 1, 3};
Circle(3) = {3, 1, 4};
Circle(4) = {4, 1, 9};
Circle(5) = {9, 1, 5};
Circle(6) = {5, 1, 6};
Circle(7) = {6, 1, 7};
Circle(8) = {7, 1, 8};
Line(9)  = {6, 1};
Line(10) = {1, 3};
Transfinite Curve {2, 3, 6, 7} = Ceil(a * r / h - 1e-9) + 1;
Transfinite Curve {9, 10} = Ceil(r / h - 1e-9) + 1;
Transfinite Curve {1, 4, 5, 8} = Ceil((Pi / 2 - a) * r / h - 1e-9) + 1;

Curve Loop(1) = {7, 8, 1, 2, -10, -9};
Plane Surface(1) = {1};
Curve Loop(2) = {3, 4, 5, 6, 9, 10};
Plane Surface(2) = {2};

Physical Surface("sliding_mass") = {1, 2};
Physical Curve("mass_surface")   = {1:8};
