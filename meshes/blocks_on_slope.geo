// Square blocks in columns and rows on a straight rigid base; the base rises to the right, its upper side is the line
// ground. The lower left corner of the blocks is at the origin [m].

DefineConstant[
  angle   = {0,  Min -80, Max 80, Name "Angle"},    // of the base [deg]
  tilt    = {0,  Min -80, Max 80, Name "Tilt"},     // of the blocks against the base, about their lower left corner [deg]
  columns = {1,  Min 1,     Name "Columns"},        // blocks along the slope
  rows    = {1,  Min 1,     Name "Rows"},           // blocks on top of each other
  width   = {1,  Min 0.001, Name "Block width"},    // [m]
  height  = {1,  Min 0.001, Name "Block height"},   // [m]
  before  = {10, Min 0.001, Name "Base below"},     // length of the base below the origin [m]
  after   = {10, Min 0.001, Name "Base above"},     // length of the base above the origin [m]
  pieces  = {1,  Min 1,     Name "Base pieces"}     // edges that the base is made of
];

c = Cos(angle * Pi / 180);
s = Sin(angle * Pi / 180);
cb = Cos((angle + tilt) * Pi / 180);
sb = Sin((angle + tilt) * Pi / 180);
length = columns * width;
top    = rows * height;

Point(1) = {0, 0, 0};
Point(2) = {cb * length, sb * length, 0};
Point(3) = {cb * length - sb * top, sb * length + cb * top, 0};
Point(4) = {-sb * top, cb * top, 0};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Transfinite Curve {1, 3} = columns + 1;
Transfinite Curve {2, 4} = rows + 1;
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

Point(5) = {-c * before, -s * before, 0};
Point(6) = {c * after, s * after, 0};
Line(5) = {5, 6};
Transfinite Curve {5} = pieces + 1;

Physical Surface("sliding_mass") = {1};
Physical Curve("ground")         = {5};
