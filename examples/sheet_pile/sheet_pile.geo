// A sheet pile that holds the ground of a quay, with the sea on the left. In metres, y = 0 is the ground behind it.
DefineConstant[
  retained  = {4.0, Name "Section/height of the ground that the wall holds, m"},
  embedded  = {5.0, Name "Section/depth of the wall below the seabed, m"},
  thickness = {0.5, Name "Section/drawn thickness of the wall, m"}
];

seabed = -retained;
foot = seabed - embedded;
rock = -12.0;
front = 14.0;             // x of the wall's seaward face
back = front + thickness;
end = 32.0;

Point(1) = {0, rock, 0};
Point(2) = {end, rock, 0};
Point(3) = {end, 0, 0};
Point(4) = {back, 0, 0};
Point(5) = {back, foot, 0};
Point(6) = {front, foot, 0};
Point(7) = {front, seabed, 0};
Point(8) = {0, seabed, 0};
Point(9) = {front, 0, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Line(9) = {4, 9};
Line(10) = {9, 7};

Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8};
Plane Surface(1) = {1};
Curve Loop(2) = {-5, -4, 9, 10, -6};
Plane Surface(2) = {2};

Physical Surface("sand") = {1};
Physical Surface("wall") = {2};
Physical Curve("rock") = {1};
Physical Curve("land_side") = {2};
Physical Curve("land") = {3};
Physical Curve("top") = {9};
Physical Curve("quay") = {10};
Physical Curve("seabed") = {7};
Physical Curve("sea_side") = {8};
