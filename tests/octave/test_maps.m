% Maps and basins: the colours of cells are those of verdicts and attractors, whole, refined, with several starts, in
% planes; numbers of fields; cells of axes that are not even.
warning('off', 'all');   % Octave discourages from gnuplot, which draws without a screen
graphics_toolkit('gnuplot');
function draw(name)
  print('-dpngcairo', '-r110', name);
  found = dir(name);
  assert(numel(found) == 1 && found.bytes > 1500);
  close('all');
  figure('visible', 'off');
end
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
function labels(x, y)
  assert(get(get(gca(), 'xlabel'), 'string'), x);
  assert(get(get(gca(), 'ylabel'), 'string'), y);
end
function names = legend_names()
  names = get(findobj(gcf(), 'tag', 'legend'), 'string')(:)';
end
function found = cell_at(handle, x, y)   % which face has a place inside
  vertices = get(handle, 'vertices');
  faces = get(handle, 'faces');
  low = [min(vertices(:, 1)(faces), [], 2), min(vertices(:, 2)(faces), [], 2)];
  high = [max(vertices(:, 1)(faces), [], 2), max(vertices(:, 2)(faces), [], 2)];
  found = find(x > low(:, 1) & x < high(:, 1) & y > low(:, 2) & y < high(:, 2));
  assert(numel(found) <= 1);
end
function colour = verdict_colour(verdict, confidence)   % as the user guide tells, mixed with white
  names = {'P-1', 'P-2', 'P-4', 'quasi-periodic', 'chaotic', 'undetermined', 'diverged', verdict};
  digits = {'366EFB', '1FBADD', '1D7257', 'CC0892', '000000', '9A9F95', 'FB8D41', '664406'};
  text = digits{find(strcmp(names, verdict), 1)};
  rgb = [hex2dec(text(1:2)), hex2dec(text(3:4)), hex2dec(text(5:6))] / 255;
  opacity = [0.4, 0.8, 1](confidence + 1);
  colour = opacity * rgb + (1 - opacity);
end
figure('visible', 'off');

% A whole map: every cell in the colour of the verdict at its place.
good = fileread([getenv('TESTS') '/cli/good.yaml']);
long = strrep(good, 'transient: 20, record: 10', 'transient: 150, record: 64');
axes_of = 'x: {parameter: omega, from: 1.0, to: 4.0, points: 9}, y: {parameter: kappa, values: [5, 6, 10, 20]}';
text = regexprep(long, '  sweep: [^\n]*', ['  map: {' axes_of '}']);
map = whirl_run(text, 'progress', false);
handle = whirl_plot_map(map);
colours = get(handle, 'facevertexcdata');
assert(size(colours), [36 3]);
for row = 1:4
  for column = 1:9
    face = cell_at(handle, map.map.x(column), map.map.y(row));
    expected = verdict_colour(map.map.verdict.name{row, column}, map.map.regime.confidence(row, column));
    assert(colours(face, :), expected, 1e-12);
  end
end
names = unique(map.map.verdict.name);
assert(numel(names) > 2 && numel(unique(map.map.regime.confidence)) > 1);
plain = names(ismember(names, {'P-1', 'P-2', 'P-4', 'chaotic', 'quasi-periodic', 'undetermined'}));
assert(all(ismember(plain, legend_names())));
assert(numel(legend_names()), numel(plain) + any(~ismember(names, plain)));
labels('omega (rad/s)', 'kappa');
% Uneven axes: cells end halfway between values.
vertices = get(handle, 'vertices');
assert(unique(vertices(:, 2)), [4.5; 5.5; 8; 15; 25], 1e-12);
assert(unique(vertices(:, 1)), (0.8125:0.375:4.1875)', 1e-12);
assert(axis(), [0.8125, 4.1875, 4.5, 25], 1e-12);
draw('map.png');

% Points of a map are numbered row by row.
handle = whirl_plot_poincare(map, 11);
assert(get(handle, 'xdata')(:), squeeze(map.map.poincare.section(2, 2, 1, :, 1)));
assert(get(get(gca(), 'title'), 'string'), ['omega = 1.375 rad/s: ' map.map.verdict.name{2, 2}]);

% Numbers, in their unit, with a colour bar.
handle = whirl_plot_map(map, 1, 'orbit/max_radius', 'disc');
numbers = get(handle, 'facevertexcdata');
for row = 1:4
  for column = 1:9
    assert(numbers(cell_at(handle, map.map.x(column), map.map.y(row))), map.map.orbit.max_radius(row, column));
  end
end
bar = findobj(gcf(), 'tag', 'colorbar');
assert(get(get(bar, 'ylabel'), 'string'), 'largest distance from the centre of disc (m 0-p)');
draw('map-numbers.png');
place = get(gca(), 'position');
whirl_plot_map(map, 1, 'orbit/max_radius');
narrow = get(gca(), 'position');
whirl_plot_map(map, 1, 'orbit/max_radius');
assert(get(gca(), 'position'), narrow, 1e-9);
assert(narrow(3) < place(3));
whirl_plot_map(map);
assert(get(gca(), 'position'), place, 1e-9);
handle = whirl_plot_map(map, [], 'orbit/high', 1, 'column', 'y');
assert(get(handle, 'facevertexcdata'), reshape(map.map.orbit.high(:, :, 1, 2), [], 1));
handle = whirl_plot_map(map, [], 'rub/max_force', 'rub at disc');
assert(get(handle, 'facevertexcdata'), map.map.rub.max_force(:) * map.map.rub.about.max_force.SI_factor);
handle = whirl_plot_map(map, [], 'lyapunov/largest');
assert(get(handle, 'facevertexcdata'), map.map.lyapunov.largest(:));
hole = map;
hole.map.lyapunov.largest(2, 3) = NaN;
handle = whirl_plot_map(hole, [], 'lyapunov/largest');
assert(size(get(handle, 'faces'), 1) == 35 && isempty(cell_at(handle, map.map.x(3), map.map.y(2))));

% The scale varies from row to row: lengths in mm go by it.
scaled = fileread([getenv('TESTS') '/octave/map_of_clearance.yaml']);
whole = whirl_run(scaled, 'progress', false);
handle = whirl_plot_map(whole, 1, 'orbit/max_radius');
millimetres = whole.map.orbit.max_radius .* (whole.map.length_scale * 1e3);
assert(get(handle, 'facevertexcdata'), millimetres(:), 1e-12);
labels('omega (rad/s)', 'c (mm)');

% A refined map beside the whole one: computed cells are the same, the others are those of the corner of their square.
refined = whirl_run(strrep(scaled, '  integrate', sprintf('    refine: 4\n  integrate')), 'progress', false);
table = refined.map;
rows = 9;
row = double(table.attributes.row);
of = zeros(rows, row);
for width = [4 2 1]   % the smaller squares lie in the larger ones
  for i = find(table.map.width == width)'
    r = floor(double(table.point(i) - 1) / row);
    c = mod(double(table.point(i) - 1), row);
    last = [r + width, c + width];
    if last(1) == rows - 1, last(1) = rows; end
    if last(2) == row - 1, last(2) = row; end
    of(r + 1:last(1), c + 1:last(2)) = i;
  end
end
for i = 1:numel(table.point)
  of(floor(double(table.point(i) - 1) / row) + 1, mod(double(table.point(i) - 1), row) + 1) = i;
end
assert(all(of(:) > 0) && numel(table.point) < numel(of));
handle = whirl_plot_map(refined);
colours = get(handle, 'facevertexcdata');
assert(size(colours, 1), numel(of));
same = 0;
for r = 1:rows
  for c = 1:row
    face = cell_at(handle, whole.map.x(c), whole.map.y(r) * 1e3);
    expected = verdict_colour(table.verdict.name{of(r, c)}, table.regime.confidence(of(r, c)));
    assert(colours(face, :), expected, 1e-12);
    same = same + isequal(expected, verdict_colour(whole.map.verdict.name{r, c}, whole.map.regime.confidence(r, c)));
  end
end
assert(size(unique(colours, 'rows'), 1) > 1 && same > 0.85 * numel(of));
draw('map-refined.png');

% A run that was stopped: cells without a point are empty.
part = refined;
part.map = rmfield(part.map, {'orbit', 'poincare'});
kept = setdiff(1:numel(table.point), of(1, 1));
for name = {'values', 'length_scale', 'point'}
  part.map.(name{1}) = part.map.(name{1})(kept);
end
part.map.map.width = part.map.map.width(kept);
part.map.map.second = part.map.map.second(kept);
part.map.verdict.name = part.map.verdict.name(kept);
for name = {'code', 'period', 'confidence'}
  part.map.regime.(name{1}) = part.map.regime.(name{1})(kept);
end
handle = whirl_plot_map(part);
assert(size(get(handle, 'faces'), 1), sum(of(:) ~= of(1, 1)));

% A map over three parameters.
third = strrep(strrep(text, 'eccentricity: 0.9 m', 'eccentricity: = e'), 'kappa: 10', sprintf('kappa: 10\n  e: 0.9 m'));
planes = whirl_run(strrep(third, axes_of, [axes_of ', z: {parameter: e, values: [0.8, 0.9]}']), 'progress', false);
for plane = 1:2
  handle = whirl_plot_map(planes, plane);
  colours = get(handle, 'facevertexcdata');
  for i = 1:36
    [r, c] = ind2sub([4, 9], i);
    expected = verdict_colour(planes.map.verdict.name{plane, r, c}, planes.map.regime.confidence(plane, r, c));
    assert(colours(cell_at(handle, planes.map.x(c), planes.map.y(r)), :), expected, 1e-12);
  end
  assert(get(get(gca(), 'title'), 'string'), sprintf('e = %g m', planes.map.z(plane)));
  handle = whirl_plot_map(planes, plane, 'orbit/max_radius');
  assert(get(handle, 'facevertexcdata'), reshape(planes.map.orbit.max_radius(plane, :, :), [], 1));
end
assert(~isequal(planes.map.verdict.name(1, :), planes.map.verdict.name(2, :)));
draw('map-plane.png');

% A basin: as many cells of an attractor as its share says, and its verdict in the legend.
several = fileread([getenv('TESTS') '/octave/several_starts.yaml']);
several = regexprep(several, '  (starts|sweep): [^\n]*\n', '');
basin = whirl_run(sprintf(['%s  initial: {disc: {x: = x0, y: = y0, vx: = -y0, vy: = x0}}\n' ...
  '  basin: {x: {parameter: x0, from: -2, to: 2, points: 9}, y: {parameter: y0, from: -1, to: 2, points: 4}}\n'], ...
  several), 'progress', false);
handle = whirl_plot_map(basin);
colours = get(handle, 'facevertexcdata');
names = legend_names();
okabe = [0, 114, 178; 230, 159, 0] / 255;
assert(numel(names), 2);
for number = 1:2
  own = all(abs(colours - okabe(number, :)) < 1e-12, 2);
  share = unique(basin.basin.share(basin.basin.attractor == number));
  assert(mean(own), share, 1e-12);
  first = find(basin.basin.attractor == number, 1);
  assert(names{number}, sprintf('attractor %d: %s (%.3g %%)', number, basin.basin.verdict.name{first}, 100 * share));
  for i = find(basin.basin.attractor == number)'
    [r, c] = ind2sub([4, 9], i);
    assert(own(cell_at(handle, basin.basin.x(c), basin.basin.y(r))));
  end
end
labels('x0', 'y0');
draw('basin.png');

% Several starts a place: what most of them lead to. The second attractor is called P-2, to tell them apart.
starts = whirl_run(sprintf(['%s  starts: {count: 9, within: {disc: {x: [-2, 2], vy: [-2, 2]}}}\n' ...
  '  map: {x: {parameter: omega, values: [120, 180, 220]}, y: {parameter: kappa, values: [10, 12]}}\n'], several), ...
  'progress', false);
starts.map.regime.period(starts.map.attractor == 2) = 2;
handle = whirl_plot_map(starts);
colours = get(handle, 'facevertexcdata');
seen = [0, 0];
for omega = [120, 180, 220]
  for kappa = [10, 12]
    own = starts.map.values == omega & starts.map.map.second == kappa;
    most = mode(double(starts.map.attractor(own)));   % nine starts: no tie of two
    first = find(own & starts.map.attractor == most, 1);
    expected = verdict_colour(sprintf('P-%d', most), starts.map.regime.confidence(first));
    assert(colours(cell_at(handle, omega, kappa), :), expected, 1e-12);
    seen(most) = seen(most) + 1;
  end
end
assert(all(seen > 0));
draw('map-starts.png');

% A number without a unit is told as a text, too.
text = regexprep(good, '  sweep: [^\n]*', '  sweep: {parameter: kappa, values: [5, 10]}');
kappa = whirl_run(text, 'progress', false);
whirl_plot_poincare(kappa, 'at', '9.5');
assert(strncmp(get(get(gca(), 'title'), 'string'), 'kappa = 10: ', 12));

wrong(@() whirl_plot_map(map, 2), 'from 1 to 1');
wrong(@() whirl_plot_map(planes, 3), 'from 1 to 2');
wrong(@() whirl_plot_map(planes, 1.5), 'from 1 to 2');
wrong(@() whirl_plot_map(map, 1, 'orbit/radius'), 'no such field');
wrong(@() whirl_plot_map(map, 1, 'orbit/max_radius', 'seal'), 'one of: disc');
wrong(@() whirl_plot_map(map, 1, 'rub/max_force', 'seal'), 'one of: rub at disc');
wrong(@() whirl_plot_map(map, 1, 'orbit/high', 'disc', 'column', 'z'), 'one of: x y');
wrong(@() whirl_plot_map(map, 1, 'poincare/section'), 'several rows');
wrong(@() whirl_plot_map(map, 'table', 'basin'), 'no such map');
disp('all well');
