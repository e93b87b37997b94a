// Slope of triangular blocks that rises to the right, its toe at the origin, on a rigid base: the line sliding_surface, which is the
// box below and beside the soil. The line ground continues it on both sides [m].

DefineConstant[
  height = {10, Min 0.001, Name "Height"},       // of the slope [m]
  run    = {2,  Min 0.001, Name "Slope"},        // horizontal over vertical
  depth  = {0,  Min 0,     Name "Depth"},        // of the soil below the toe; 0: the base is level with the toe [m]
  front  = {10, Min 0.001, Name "Front"},        // length of the soil before the toe, if it has a depth [m]
  behind = {20, Min 0.001, Name "Behind"},       // length of the crest [m]
  algo   = {5,  Min 1, Max 6, Name "Algorithm"}, // of gmsh: 5 Delaunay, 1 MeshAdapt, 6 frontal Delaunay
  h      = {1,  Min 0.001, Name "Resolution/h"}  // edge length
];

back = run * height + behind;
Point(1) = {0, 0, 0};                 // toe
Point(2) = {run * height, height, 0}; // crest
Point(3) = {back, height, 0};
Point(4) = {back, -depth, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
If (depth > 0)
  Point(5) = {-front + 0.02 * depth, -depth, 0}; // a surface runs from left to right: no vertical wall on this side
  Point(6) = {-front, 0, 0};
  Line(4)  = {5, 4};
  Line(5)  = {6, 5};
  Line(6)  = {6, 1};
  Curve Loop(1) = {5, 4, 3, -2, -1, -6};
  Physical Curve("sliding_surface") = {5, 4, 3};
  Physical Curve("mass_surface")    = {6, 1, 2};
  first = 6;
Else
  Line(4) = {1, 4};
  Curve Loop(1) = {4, 3, -2, -1};
  Physical Curve("sliding_surface") = {4, 3};
  Physical Curve("mass_surface")    = {1, 2};
  first = 1;
EndIf
Plane Surface(1) = {1};
MeshSize {:} = h;
Mesh.Algorithm = algo;

Point(7) = {depth > 0 ? -front - 2 : -2, 0, 0};
Point(8) = {back + 2, height, 0};
Line(7) = {7, first};
Line(8) = {3, 8};
Transfinite Curve {7, 8} = 2;

Physical Surface("sliding_mass") = {1};
Physical Curve("ground")         = {7, 8};
