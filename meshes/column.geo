// Rectangular column of structured quadrilaterals, base at y = 0, left side at x = 0 [m]; optional layer on top.

DefineConstant[
  width  = {10,  Min 0.001, Name "Width"},         // [m]
  height = {100, Min 0.001, Name "Height"},        // of the whole column [m]
  layer  = {0,   Min 0,     Name "Layer height"},  // of the region bedrock_soft on top [m]; 0: none
  h      = {5,   Min 0.001, Name "Resolution/h"}   // largest edge length [m]
];

If (layer >= height)
  Error("Layer height = %g must be less than Height = %g", layer, height);
EndIf

// ---- levels from the base upwards, at least one cell each
level[] = {0, height - layer};
If (layer > 0)
  level[] += height;
EndIf
columns = Ceil(width / h - 1e-9);

For i In {0:#level[] - 1}
  a = newp; Point(a) = {0, level[i], 0};
  b = newp; Point(b) = {width, level[i], 0};
  l = newl; Line(l) = {a, b};
  Transfinite Curve {l} = columns + 1;
  If (i == 0)
    base = l;
  Else
    rows = Ceil((level[i] - level[i - 1]) / h - 1e-9);
    ll = newl; Line(ll) = {below_a, a};
    lr = newl; Line(lr) = {below_b, b};
    Transfinite Curve {ll, lr} = rows + 1;
    loop = newll; Curve Loop(loop) = {below, lr, -l, -ll};
    s = news; Plane Surface(s) = {loop};
    Transfinite Surface {s};
    Recombine Surface {s};
    part[]  += s;
    left[]  += ll;
    right[] += lr;
  EndIf
  below   = l;
  below_a = a;
  below_b = b;
EndFor

Physical Surface("bedrock") = {part[0]};
If (layer > 0)
  Physical Surface("bedrock_soft") = {part[1]};
EndIf
Physical Curve("base")   = {base};
Physical Curve("left")   = {left[]};
Physical Curve("right")  = {right[]};
Physical Curve("ground") = {below};
