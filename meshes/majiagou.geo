// Majiagou landslide, Badong: reconstructed section (majiagou_section.csv), x uphill, y above sea level [m].
// The bedrock is cut into five layers by the bedding planes and by unnamed continuations to the sides,
// so that every plane is a row of element edges and still ends as a tip.

DefineConstant[ h = {4, Min 1, Max 20, Name "Resolution/h"} ]; // edge length in the mass and at the slip surface [m]

// The toe part, which is thin and yields first, is finer.
toe_part   = 0.6; // of h up to toe_end
toe_end    = 345; // where its slip ends, at rest and in the Badong earthquake [m]
toe_growth = 60;  // and h from there on over this distance [m]

DefineConstant[ size_far = {24, Min 1, Name "Section/far"} ]; // bedrock far from the slip surface [m]
growth_start = h;   // the size stays h up to this distance below the slip surface [m]
growth_end   = 130; // and reaches size_far here [m]

Mesh.Algorithm                              = 6; // frontal Delaunay; 8 crashes in gmsh 4.8.4
Mesh.RecombinationAlgorithm                 = 3; // blossom full-quad: no triangle is left over
Mesh.CharacteristicLengthFromPoints         = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;

// ---- slip surface, toe to crest: a smooth curve through the points of the section. A mass that slides over knees
// has to shear through at each of them, along whatever block edges the mesh has there.
slip_x[] = {200, 228, 258, 288, 334, 400, 470, 540, 600, 655, 690, 712};
slip_y[] = {130, 136, 140.5, 147, 164, 184.5, 205.5, 222.5, 239, 259, 275, 290};
For i In {0:#slip_x[] - 1}
  slip_point[] += newp;
  Point(slip_point[i]) = {slip_x[i], slip_y[i], 0};
EndFor
last_point = #slip_x[] - 1;
For i In {0:last_point - 1}
  run[]   += slip_x[i + 1] - slip_x[i];
  slope[] += (slip_y[i + 1] - slip_y[i]) / run[i]; // of the straight line
EndFor
// slope of the curve at each point: of the parabola through it and its neighbours
For i In {0:last_point}
  a = i - 1;
  If (i == 0)
    a = 0;
  ElseIf (i == last_point)
    a = last_point - 2;
  EndIf
  bend = (slope[a + 1] - slope[a]) / (run[a] + run[a + 1]);
  curve_slope[] += slope[a] + bend * (2 * slip_x[i] - slip_x[a] - slip_x[a + 1]);
EndFor
pieces = 10; // of the spline through each part: cubic with the slopes at its ends (Hermite)
For i In {0:last_point - 1}
  part[] = {slip_point[i]};
  For k In {1:pieces - 1}
    t = k / pieces;
    p = newp;
    Point(p) = {slip_x[i] + t * run[i],
                slip_y[i] * (1 + 2 * t) * (1 - t)^2 + slip_y[i + 1] * (3 - 2 * t) * t^2 +
                (curve_slope[i] * (1 - t) - curve_slope[i + 1] * t) * run[i] * t * (1 - t), 0};
    part[] += p;
  EndFor
  part[] += slip_point[i + 1];
  l = newl;
  Spline(l) = {part[]};
  slip[] += l;
EndFor
toe   = slip_point[0];
crest = slip_point[#slip_x[] - 1];

// ---- ground on the sliding mass, toe to crest
mass_x[] = {243, 288, 334, 400, 470, 580, 668};
mass_y[] = {163, 177, 190, 209, 228, 250, 272};
last = toe;
For i In {0:#mass_x[] - 1}
  p = newp;
  Point(p) = {mass_x[i], mass_y[i], 0};
  l = newl;
  Line(l) = {last, p};
  mass_surface[] += l;
  last = p;
EndFor
l = newl;
Line(l) = {last, crest};
mass_surface[] += l;

// ---- ground on the bedrock, valley side and above the crest
valley_x[] = {-200, 0, 45, 110, 158, 186};
valley_y[] = {215, 215, 196, 160, 121, 120};
For i In {0:#valley_x[] - 1}
  p = newp;
  Point(p) = {valley_x[i], valley_y[i], 0};
  If (i == 0)
    top_left = p;
  Else
    l = newl;
    Line(l) = {last, p};
    valley[] += l;
  EndIf
  last = p;
EndFor
l = newl;
Line(l) = {last, toe};
valley[] += l;

upper_x[] = {760, 900, 1100};
upper_y[] = {306, 338, 338};
last = crest;
For i In {0:#upper_x[] - 1}
  p = newp;
  Point(p) = {upper_x[i], upper_y[i], 0};
  l = newl;
  Line(l) = {last, p};
  upper[] += l;
  last = p;
EndFor
top_right = last;

// ---- bedding planes 1..4 from tip to tip, continued to the sides (spreading, so that far cells stay well shaped)
tip_left_y[]  = {51.98, 35.30, 18.61, 1.92};
tip_right_y[] = {318.58, 301.89, 285.20, 268.51};
side_left_y[]  = {90, 55, 20, -15};
side_right_y[] = {300, 265, 230, 195};
roof[]     = {valley[], slip[], upper[]}; // upper boundary of the layer, left to right
left_last  = top_left;
right_last = top_right;
For k In {0:3}
  a = newp; Point(a) = {-200, side_left_y[k], 0};
  b = newp; Point(b) = {0, tip_left_y[k], 0};
  c = newp; Point(c) = {900, tip_right_y[k], 0};
  d = newp; Point(d) = {1100, side_right_y[k], 0};
  l1 = newl; Line(l1) = {a, b};
  l2 = newl; Line(l2) = {b, c};
  l3 = newl; Line(l3) = {c, d};
  l4 = newl; Line(l4) = {left_last, a};
  l5 = newl; Line(l5) = {d, right_last};
  bedding[] += l2;
  left[]    += l4;
  right[]   += l5;
  loop[] = {l4, l1, l2, l3, l5};
  For i In {#roof[] - 1:0:-1}
    loop[] += -roof[i];
  EndFor
  ll = newll; Curve Loop(ll) = {loop[]};
  s = news; Plane Surface(s) = {ll};
  bedrock[] += s;
  roof[] = {l1, l2, l3};
  left_last  = a;
  right_last = d;
EndFor

// ---- base
a = newp; Point(a) = {-200, -60, 0};
b = newp; Point(b) = {1100, -60, 0};
l4 = newl; Line(l4) = {left_last, a};
base = newl; Line(base) = {a, b};
l5 = newl; Line(l5) = {b, right_last};
left[]  += l4;
right[] += l5;
ll = newll; Curve Loop(ll) = {l4, base, l5, -roof[2], -roof[1], -roof[0]};
s = news; Plane Surface(s) = {ll};
bedrock[] += s;

// ---- sliding mass
loop[] = {slip[]};
For i In {#mass_surface[] - 1:0:-1}
  loop[] += -mass_surface[i];
EndFor
ll = newll; Curve Loop(ll) = {loop[]};
mass = news; Plane Surface(mass) = {ll};

// ---- size: h in the mass and at the slip surface (less at the toe), growing with the distance from it
Field[1] = Distance;
Field[1].CurvesList = {slip[]};
Field[1].NumPointsPerCurve = 100;
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = h;
Field[2].SizeMax = size_far;
Field[2].DistMin = growth_start;
Field[2].DistMax = growth_end;
Field[3] = MathEval;
Field[3].F = Sprintf("%.16g * (%g + %g * Min(1, Max(0, (x - %g) / %g)))", h, toe_part, 1 - toe_part, toe_end, toe_growth);
Field[4] = Restrict;
Field[4].InField = 3;
Field[4].SurfacesList = {mass};
Field[4].CurvesList = {mass_surface[], slip[]};
Field[5] = Min;
Field[5].FieldsList = {2, 4};
Background Field = 5;

Recombine Surface {bedrock[]};

Physical Surface("bedrock")       = {bedrock[]};
Physical Surface("sliding_mass")  = {mass};
Physical Curve("sliding_surface") = {slip[]};
Physical Curve("mass_surface")    = {mass_surface[]};
Physical Curve("ground")          = {valley[], upper[]};
Physical Curve("bedding_1")       = {bedding[0]};
Physical Curve("bedding_2")       = {bedding[1]};
Physical Curve("bedding_3")       = {bedding[2]};
Physical Curve("bedding_4")       = {bedding[3]};
Physical Curve("base")            = {base};
Physical Curve("left")            = {left[]};
Physical Curve("right")           = {right[]};
