// A layer [0,H] x [0,W] x [0,L] in mm of n1 x n2 x n3 hexahedra (n2, n3 even), or with quarter = 1
// the quarter of it with x2 < W/2 and x3 < L/2. Region: layer. Surfaces: inner (x1 = 0),
// outer (x1 = H), x2_min, x2_max, x3_min, x3_max. Line: centre (x2 = W/2, x3 = L/2).
DefineConstant[
  L = {20, Name "L"}, W = {4, Name "W"}, H = {1, Name "H"},
  n1 = {4, Name "n1", Min 1, Max 500, Step 1}, n2 = {8, Name "n2", Min 1, Max 500, Step 1},
  n3 = {20, Name "n3", Min 1, Max 500, Step 1},
  quarter = {0, Name "quarter", Min 0, Max 1, Step 1}
];
halves = quarter ? 1 : 2;
Point(1) = {0, 0, 0};
line[] = Extrude {H, 0, 0} { Point{1}; Layers{n1}; };
from = line[1];
sections[] = {};
For half In {1:halves}
  strip[] = Extrude {0, W/2, 0} { Line{from}; Layers{n2/2}; Recombine; };
  from = strip[0];
  sections[] += strip[1];
EndFor
blocks[] = {};
For half In {1:halves}
  next[] = {};
  For s In {0:halves-1}
    block[] = Extrude {0, 0, L/2} { Surface{sections[s]}; Layers{n3/2}; Recombine; };
    next[] += block[0];
    blocks[] += block[1];
  EndFor
  sections[] = next[];
EndFor
Physical Volume("layer") = blocks[];
e = H * 1e-6;
w = halves * W/2;
l = halves * L/2;
Physical Surface("inner") = Surface In BoundingBox {-e, -e, -e, e, w+e, l+e};
Physical Surface("outer") = Surface In BoundingBox {H-e, -e, -e, H+e, w+e, l+e};
Physical Surface("x2_min") = Surface In BoundingBox {-e, -e, -e, H+e, e, l+e};
Physical Surface("x2_max") = Surface In BoundingBox {-e, w-e, -e, H+e, w+e, l+e};
Physical Surface("x3_min") = Surface In BoundingBox {-e, -e, -e, H+e, w+e, e};
Physical Surface("x3_max") = Surface In BoundingBox {-e, -e, l-e, H+e, w+e, l+e};
Physical Curve("centre") = Curve In BoundingBox {-e, W/2-e, L/2-e, H+e, W/2+e, L/2+e};
