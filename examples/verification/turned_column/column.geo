// A column of soil, turned about its lower left corner, in metres.
DefineConstant[
  width  = {0.3, Name "Column/width, m"},
  height = {1.0, Name "Column/height, m"},
  angle  = {30, Name "Column/angle, degrees"},
  x0     = {0, Name "Column/x of the corner, m"},
  y0     = {0, Name "Column/y of the corner, m"}
];
c = Cos(angle * Pi / 180); s = Sin(angle * Pi / 180);
Point(1) = {x0, y0, 0};
Point(2) = {x0 + width * c, y0 + width * s, 0};
Point(3) = {x0 + width * c - height * s, y0 + width * s + height * c, 0};
Point(4) = {x0 - height * s, y0 + height * c, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("soil") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("surface") = {3};
Physical Curve("left") = {4};
