// A dike of sand over a culvert, on rock that a spline follows, in metres.
DefineConstant[
  height   = {2.0, Name "Section/height of the dike, m"},
  slope    = {2.0, Name "Section/slope, horizontal run for a rise of one"},
  diameter = {1.6, Name "Section/outer diameter of the culvert, m"}
];

crest = 4.0;              // width of the crest, m
ground = 3.0;             // level of the ground, m
middle = 12.0;            // x of the middle of the dike, m
toe = crest / 2 + slope * height;

// rock, from left to right
Point(1) = {0, 0.5, 0};
Point(2) = {8, -1.2, 0};
Point(3) = {16, 0.2, 0};
Point(4) = {24, -0.4, 0};
Spline(1) = {1, 2, 3, 4};

// sides and surface
Point(5) = {24, ground, 0};
Point(6) = {middle + toe, ground, 0};
Point(7) = {middle + crest / 2, ground + height, 0};
Point(8) = {middle - crest / 2, ground + height, 0};
Point(9) = {middle - toe, ground, 0};
Point(10) = {0, ground, 0};
Line(2) = {4, 5};
Line(3) = {5, 6};
Line(4) = {6, 7};
Line(5) = {7, 8};
Line(6) = {8, 9};
Line(7) = {9, 10};
Line(8) = {10, 1};

// culvert
Point(20) = {middle, 2.6, 0};
Point(21) = {middle + diameter / 2, 2.6, 0};
Point(22) = {middle - diameter / 2, 2.6, 0};
Circle(20) = {21, 20, 22};
Circle(21) = {22, 20, 21};

Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Curve Loop(2) = {20, 21};
Plane Surface(1) = {1, 2};
Mesh.MeshSizeMax = 0.5; // curves become polygons of such edges

Physical Surface("sand") = {1};
Physical Curve("rock") = {1};
Physical Curve("right") = {2};
Physical Curve("surface") = {3, 4, 5, 6, 7};
Physical Curve("left") = {8};
Physical Curve("culvert") = {20, 21};
