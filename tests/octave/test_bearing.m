% Bearings out of files and structs are those of the command: a bearing with two grooves, whose digits two
% methods agree on.
function wrong(call, part)
  try
    call();
  catch problem
    assert(problem.identifier, 'whirl:badInput');
    assert(~isempty(strfind(problem.message, part)), problem.message);
    return
  end
  error('no error: %s', func2str(call));
end
file = struct('kind', 'two-groove', 'diameter', 0.1, 'length', 0.05, 'clearance', 1e-4, 'viscosity', 0.02);
file.speed = 1000 * pi / 30;
file.load = 0.02 * 1000 / 60 * 0.1 * 0.05 * 500^2 ./ [0.917, 0.379];
found = whirl_bearing(file);
assert([found.points.sommerfeld], [0.917, 0.379], 1e-9);
assert([found.points.eccentricity_ratio], [0.3716548, 0.5696463], 5e-6);
assert([found.points.attitude] * 180 / pi, [57.52602, 45.52281], 5e-4);
assert(1e-4 / found.points(2).load * found.points(2).stiffness, [1.7042, 0.4441; -3.6596, 3.3125], 1e-3);
point = whirl_bearing([getenv('TESTS') '/fuzz/corpus/bearing/two-groove.yaml']);
assert(numel(point.points), 2);
warm = rmfield(file, 'viscosity');
warm.grade = 46;
warm.supply_temperature = 318.15;
warm.supply_pressure = 1e5;
warm.turbulence = 'ng-pan';
point = whirl_bearing(warm).points(2);
assert(point.temperature, 0.5 * (318.15 + point.outlet), 2e-3);
assert(point.outlet - 318.15, point.power / (870 * 1950 * point.flow), 4e-3);
wrong(@() whirl_bearing(setfield(file, 'groove', 0.5)), 'belongs to supply_pressure');
file.kind = 'two';
wrong(@() whirl_bearing(file), 'kind: is two, expected one of plain');
wrong(@() whirl_bearing('none.yaml'), 'none.yaml');
wrong(@() whirl_bearing(3), 'whirl_bearing takes the name of a file');
disp('all well');
