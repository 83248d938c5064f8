// Half a stack above its plane of symmetry x3 = 0, and of that the half with x2 > 0: n layers of h,
// [0,L] x [0,W/2] x [0,n h] in mm. Electrodes lie below, between and above the layers. Those at
// x3 = 0, 2h, ... (`ground`) begin at x1 = 0 and end m before x1 = L, those at x3 = h, 3h, ...
// (`live`) begin m behind x1 = 0 and end at x1 = L; without margins, m = 0, they cover everything.
// n1 (even) x n2 cells in the plane and nm more in each margin, n3 in every layer. Region: film.
// Surfaces: ground, live, bottom (x3 = 0), top, x1_min, x1_max, x2_min. Point: centre (x2 = x3 = 0).
DefineConstant[
  L = {10, Name "L"}, W = {6, Name "W"}, h = {0.5, Name "h"}, m = {1, Name "m"},
  n = {4, Name "n", Min 1, Max 500, Step 1}, n1 = {8, Name "n1", Min 2, Max 500, Step 2},
  nm = {2, Name "nm", Min 1, Max 500, Step 1}, n2 = {3, Name "n2", Min 1, Max 500, Step 1},
  n3 = {1, Name "n3", Min 1, Max 500, Step 1}
];
lengths[] = {L/2 - m, L/2 - m};
cells[] = {n1/2, n1/2};
If (m > 0)
  lengths[] = {m, lengths[], m};
  cells[] = {nm, cells[], nm};
EndIf
parts = #lengths[];
Point(1) = {0, 0, 0};
end = 1;
areas[] = {};
For p In {0:parts-1}
  line[] = Extrude {lengths[p], 0, 0} { Point{end}; Layers{cells[p]}; };
  end = line[0];
  area[] = Extrude {0, W/2, 0} { Line{line[1]}; Layers{n2}; Recombine; };
  areas[] += area[1];
EndFor
bottom[] = areas[];
margin = m > 0 ? 1 : 0;
ground[] = areas[{0:parts-1-margin}];
live[] = {};
bodies[] = {};
For layer In {1:n}
  For p In {0:parts-1}
    body[] = Extrude {0, 0, h} { Surface{areas[p]}; Layers{n3}; Recombine; };
    areas[p] = body[0];
    bodies[] += body[1];
  EndFor
  If (layer % 2)
    live[] += areas[{margin:parts-1}];
  Else
    ground[] += areas[{0:parts-1-margin}];
  EndIf
EndFor
e = h * 1e-6;
Physical Volume("film") = bodies[];
Physical Surface("ground") = ground[];
Physical Surface("live") = live[];
Physical Surface("bottom") = bottom[];
Physical Surface("top") = areas[];
Physical Surface("x1_min") = Surface In BoundingBox {-e, -e, -e, e, W/2+e, n*h+e};
Physical Surface("x1_max") = Surface In BoundingBox {L-e, -e, -e, L+e, W/2+e, n*h+e};
Physical Surface("x2_min") = Surface In BoundingBox {-e, -e, -e, L+e, e, n*h+e};
Physical Point("centre") = Point In BoundingBox {L/2-e, -e, -e, L/2+e, e, e};
