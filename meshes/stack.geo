// Half of the width and half of the height of a stack of bonded layers with interdigitated electrodes:
// [0,L] x [0,W] x [0,N h] in mm, N layers of thickness h above the middle plane x3 = 0, which is an
// electrode as are all planes between layers, high and low by turns. A margin of length m at x1 = L
// is left out by the high ones and one at x1 = 0 by the low ones. Cells: n1 in each margin, nc (even)
// between them, n2, n3 a layer. Region: stack. Surfaces: high, low, and on the same planes high_margin,
// low_margin, which are no electrodes in a stack; x1_min, x1_max,
// x2_min, x3_min, top. Line: pin (x1 = L/2, x3 = 0).
DefineConstant[
  L = {20, Name "L"}, W = {4, Name "W"}, h = {1, Name "h"}, m = {2, Name "m"}, N = {3, Name "N"},
  n1 = {2, Name "n1"}, nc = {6, Name "nc"}, n2 = {2, Name "n2"}, n3 = {1, Name "n3"}
];
Point(1) = {0, 0, 0};
edge[] = Extrude {0, W, 0} { Point{1}; Layers{n2}; };
left[] = Extrude {m, 0, 0} { Line{edge[1]}; Layers{n1}; Recombine; };
half[] = Extrude {L/2-m, 0, 0} { Line{left[0]}; Layers{nc/2}; Recombine; };
other[] = Extrude {L/2-m, 0, 0} { Line{half[0]}; Layers{nc/2}; Recombine; };
right[] = Extrude {m, 0, 0} { Line{other[0]}; Layers{n1}; Recombine; };
below[] = {left[1], half[1], other[1], right[1]};
For i In {1:N}
  For k In {0:3}
    block[] = Extrude {0, 0, h} { Surface{below[k]}; Layers{n3}; Recombine; };
    below[k] = block[0];
    volumes[] += block[1];
  EndFor
EndFor
e = h * 1e-6;
high[] = {}; low[] = {}; high_margin[] = {}; low_margin[] = {};
For i In {0:N}
  at_left[] = Surface In BoundingBox {-e, -e, i*h-e, m+e, W+e, i*h+e};
  at_right[] = Surface In BoundingBox {L-m-e, -e, i*h-e, L+e, W+e, i*h+e};
  between[] = Surface In BoundingBox {m-e, -e, i*h-e, L-m+e, W+e, i*h+e};
  If (i % 2 == 0)
    high[] += {at_left[], between[]};
    high_margin[] += at_right[];
  Else
    low[] += {between[], at_right[]};
    low_margin[] += at_left[];
  EndIf
EndFor
Physical Volume("stack") = volumes[];
Physical Surface("high") = high[];
Physical Surface("low") = low[];
Physical Surface("high_margin") = high_margin[];
Physical Surface("low_margin") = low_margin[];
Physical Surface("x1_min") = Surface In BoundingBox {-e, -e, -e, e, W+e, N*h+e};
Physical Surface("x1_max") = Surface In BoundingBox {L-e, -e, -e, L+e, W+e, N*h+e};
Physical Surface("x2_min") = Surface In BoundingBox {-e, -e, -e, L+e, e, N*h+e};
Physical Surface("x3_min") = Surface In BoundingBox {-e, -e, -e, L+e, W+e, e};
Physical Surface("top") = Surface In BoundingBox {-e, -e, N*h-e, L+e, W+e, N*h+e};
Physical Curve("pin") = Curve In BoundingBox {L/2-e, -e, -e, L/2+e, W+e, e};
