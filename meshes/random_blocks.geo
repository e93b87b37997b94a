// Rectangle of triangular blocks with scattered corners, so that edges run in all directions, on a straight rigid base,
// the line sliding_surface, which the line ground continues on both sides. The lower left corner is at the origin [m].

DefineConstant[
  width   = {4,   Min 0.001, Name "Width"},        // [m]
  height  = {8,   Min 0.001, Name "Height"},       // [m]
  beyond  = {2,   Min 0.001, Name "Base beyond"},  // length of the base on either side [m]
  scatter = {0.5, Min 0, Max 0.9, Name "Scatter"},  // of the corners, over the edge length
  seed    = {1,   Min 1, Name "Seed"},             // of the corners' places: another one is another mesh
  h       = {1,   Min 0.001, Name "Resolution/h"}  // edge length
];

columns = Ceil(width / h - 1e-9);
rows    = Ceil(height / h - 1e-9);
dx      = width / columns;
dy      = height / rows;

Point(1) = {0, 0, 0, h};
Point(2) = {width, 0, 0, h};
Point(3) = {width, height, 0, h};
Point(4) = {0, height, 0, h};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Transfinite Curve {1, 3} = columns + 1;
Transfinite Curve {2, 4} = rows + 1;
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};

// Rows of corners, every other one shifted by half an edge; a linear congruential generator scatters them.
r = seed * 7919 % 65537;
For j In {1:rows - 1}
  shift = (j % 2) * 0.5;
  For i In {1:columns - 1}
    r = (r * 75 + 74) % 65537;
    x = (i - 0.25 + shift + scatter * (r / 65537 - 0.5)) * dx;
    r = (r * 75 + 74) % 65537;
    y = (j + scatter * (r / 65537 - 0.5)) * dy;
    p = newp;
    Point(p) = {x, y, 0, 2 * h};
    Point{p} In Surface{1};
  EndFor
EndFor

left  = newp; Point(left)  = {-beyond, 0, 0};
right = newp; Point(right) = {width + beyond, 0, 0};
Line(5) = {left, 1};
Line(6) = {2, right};
Transfinite Curve {5, 6} = 2;

// Delaunay triangles of these corners; no others are added.
Mesh.Algorithm                  = 5;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeMin                = h;

Physical Surface("sliding_mass")  = {1};
Physical Curve("sliding_surface") = {1};
Physical Curve("mass_surface")    = {2, 3, 4};
Physical Curve("ground")          = {5, 6};
