% The functions draw panels of figures: of the table, station, point and field that is asked for, into the current axes.
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
function items = list_of(decoded)
  if iscell(decoded), items = decoded(:); else, items = num2cell(decoded(:)); end
end
function same_as_figure(handles, result, name, panel)   % every series of the panel that has numbers
  drawn = arrayfun(@(one) {get(one, 'xdata')(:)}, handles(strcmp(get(handles, 'type'), 'line')));
  of_figure = whirl_figure(result, name, 'panels', panel);
  panels = list_of(of_figure.data.panels);
  series = list_of(panels{1}.series);
  kept = cellfun(@(one) isfield(one, 'x') && ~isempty(one.x) && any(strcmp(one.shape, {'dots', 'line'})), series);
  series = series(kept);
  assert(numel(series) > 0);
  for i = 1:numel(series)
    assert(any(cellfun(@(x) isequaln(x, series{i}.x(:)), drawn)));
  end
  close('all');
  figure('visible', 'off');
end
function list = points_of(handles)   % all points of lines, each once
  list = zeros(0, 2);
  for handle = handles(:)'
    if strcmp(get(handle, 'type'), 'line')
      list = [list; get(handle, 'xdata')(:), get(handle, 'ydata')(:)];
    end
  end
  list = unique(list(~any(isnan(list), 2), :), 'rows');
end
function yes = among(points, others)   % each of these lines is one of those: Octave's jsondecode errs in last digits
  far = zeros(rows(points), 1);
  for i = 1:rows(points)
    far(i) = min(max(abs(others - points(i, :)), [], 2));
  end
  yes = all(far <= 1e-12 * max(abs(others(:))));
end
figure('visible', 'off');
good = fileread([getenv('TESTS') '/cli/good.yaml']);
waves = regexprep(good, '  analyze: .*', ...
  "  keep: {waveform: 4}\n  analyze: [poincare, regime, lyapunov, spectrum, orbit, waveform]\n");

% A run that is not kept has its file for figures, until eight more are done.
one = whirl_run(strrep(good, 'points: 5', 'points: 2'), 'progress', false);
assert(exist(one.attributes.file, 'file'), 2);
save('-binary', 'one.mat', 'one');
for i = 1:8
  last = whirl_run(strrep(good, 'points: 5', 'points: 2'), 'progress', false);
end
assert(exist(one.attributes.file, 'file') == 0 && exist(last.attributes.file, 'file') == 2);
wrong(@() whirl_plot_bifurcation(one), 'is gone or another one by now');
result = whirl_run(strrep(waves, 'points: 5', 'points: 9'), 'progress', false, 'output', 'waves.h5');
sweep = result.sweep;

% Diagrams have the numbers of the result, in the units of the case.
section = squeeze(sweep.poincare.section(:, 1, :, 2));
drawn = points_of(whirl_plot_bifurcation(result, 'disc', 'y'));
near = (max(section(:)) - min(section(:))) / 1000;
for i = 1:numel(sweep.values)
  own = drawn(abs(drawn(:, 1) - sweep.values(i)) < 1e-9, 2);
  assert(among(own, section(i, :)'));
  assert(all(min(abs(section(i, :) - own), [], 1) < near));   % nearer ones are drawn once
end
assert(get(get(gca(), 'ylabel'), 'string'), '{\it y} (m)');
draw('bifurcation.png');
assert(points_of(whirl_plot_bifurcation(result, 1, 2)), drawn);
velocity = points_of(whirl_plot_bifurcation(result, [], 'vx'));
assert(among(velocity(:, 2), squeeze(sweep.poincare.section(:, 1, :, 3))(:)) && rows(velocity) > 9);
exponent = points_of(whirl_plot_lyapunov(result));
assert(among([sweep.values, sweep.lyapunov.largest], exponent));
draw('lyapunov.png');

% One point: by its number, by a value, by a text.
for call = {@() whirl_plot_poincare(result, 5, 1), @() whirl_plot_poincare(result, [], 1, 'at', 2.53), ...
    @() whirl_plot_poincare(result, 'at', '2.5 rad/s'), @() whirl_plot_poincare(result, 'at', '23.873 rpm')}
  drawn = points_of(call{1}());
  section = squeeze(sweep.poincare.section(5, 1, :, 1:2));
  assert(among(drawn, section) && among(section, drawn));
end
assert(get(get(gca(), 'title'), 'string'), ['omega = 2.5 rad/s, disc: ' sweep.verdict.name{5}]);
draw('poincare.png');
path = squeeze(sweep.waveform.samples(9, 1, :, 1:2));
assert(among(path, points_of(whirl_plot_orbit(result, 9, 'disc'))));
draw('orbit.png');
lines_of = squeeze(sweep.spectrum.lines(9, 1, :, :));
lines_of = lines_of(~isnan(lines_of(:, 1)), :);
tips = points_of(whirl_plot_spectrum(result, 9));
assert(among([lines_of(:, [1 4]); [-lines_of(:, 1), lines_of(:, 5)]], tips));
draw('spectrum.png');
whirl_plot_waterfall(result, 'disc', 'highest_order', 1.5);
assert(get(gca(), 'xlim'), [-1.5, 1.5]);
draw('waterfall.png');
text = [strtrim(good) sprintf('\n  detail: {at: [1.0, 3.25], transient: 30, record: 12}\n')];
detail = whirl_run(text, 'progress', false);
assert(~isempty(whirl_plot_spectrum(detail, 1, 'disc', 'full', false)));   % of the details, which have whole spectra
both = strrep(good, 'start: state', 'start: carry, direction: both');
assert(~isempty(whirl_plot_waterfall(whirl_run(both, 'progress', false))));
bare = whirl_run(regexprep(good, 'poincare, regime, ', ''), 'progress', false);
drawn = points_of(whirl_plot_lyapunov(bare));
assert(among(bare.sweep.lyapunov.largest, drawn(:, 2)));
for table = {'sweep', 'detail'}
  section = squeeze(detail.(table{1}).poincare.section(2, 1, :, 1:2));
  drawn = points_of(whirl_plot_poincare(detail, 2, 'disc', 'table', table{1}));
  assert(among(drawn, section) && among(section, drawn));
end
assert(rows(section), 12);

% A figure takes the place of the one before, unless that is held.
whirl_plot_poincare(result, 3);
count = numel(get(gca(), 'children'));
whirl_plot_poincare(result, 3);
assert(numel(get(gca(), 'children')), count);
hold('on');
whirl_plot_poincare(result, 5);
assert(numel(get(gca(), 'children')) > count && ishold());
limits = get(gca(), 'xlim');
both = squeeze(sweep.poincare.section([3, 5], 1, :, 1))(:);
assert(limits(1) < min(both) && max(both) < limits(2));
hold('off');

% Several starts: every attractor, and which share of the starts leads to it.
several = fileread([getenv('TESTS') '/octave/several_starts.yaml']);
starts = whirl_run(several, 'progress', false);
drawn = points_of(whirl_plot_bifurcation(starts));
section = squeeze(starts.sweep.poincare.section(:, 1, :, 1));
assert(unique(drawn(:, 1)), unique(starts.sweep.values), 1e-9);
assert(among(drawn(:, 2), section(:)));
shares = points_of(whirl_plot_shares(starts));
for number = 1:2
  for place = unique(starts.sweep.values(starts.sweep.attractor == number))'
    of_place = starts.sweep.values == place & starts.sweep.starts.neighbour == 0;
    share = 100 * mean(starts.sweep.attractor(of_place) == number);
    assert(any(abs(shares(:, 1) - place) < 1e-9 & abs(shares(:, 2) - share) < 1e-9));
  end
end
draw('shares.png');

% Branches and machines at rest.
branch = whirl_run([getenv('TESTS') '/cli/branch.yaml'], 'progress', false);
same_as_figure(whirl_plot_branches(branch, 'disc', 'y'), branch, 'branch-disc', 'y');
whirl_plot_branches(branch);
draw('branches.png');
modes = whirl_run([getenv('TESTS') '/cli/modes.yaml'], 'progress', false);
rpm = 2 * pi / 60;
drawn = points_of(whirl_plot_campbell(modes));
for tuned = sqrt([80e3, 200e3] / 2) / rpm   % springs are in tune with the speed where it is sqrt(k/m)
  assert(min(max(abs(drawn - tuned), [], 2)) < 1e-6);
end
draw('campbell.png');
text = fileread([getenv('TESTS') '/cli/modes.yaml']);
text = [text(1:strfind(text, 'study:') - 1) ...
  sprintf('study:\n  unbalance: {parameter: omega, from: 500 rpm, to: 1500 rpm, points: 9}\n  units: um, p-p\n')];
response = whirl_run(text, 'progress', false);
conditions = strrep(strrep(text, 'omega: 1000 rpm', sprintf('omega: 1000 rpm\n  k: 80 kN/m')), '80 kN/m}', '= k}');
conditions = sprintf('%s  conditions: {soft: {}, stiff: {k: 300 kN/m}}\n', conditions);
assert(~isempty(whirl_plot_bode(whirl_run(conditions, 'progress', false))));
both = whirl_plot_bode(response, 'disc');
drawn = points_of(both{1});
turns = unique(drawn(:, 1)) * rpm;
expected = 20 * turns.^2 ./ abs(80e3 / 2 - turns.^2);   % 2 e r^2/(1 - r^2), e = 10 um, along x
assert(numel(turns) == 9 && all(arrayfun(@(size) min(abs(drawn(:, 2) - size)), expected) < 1e-6));
assert(~isempty(both{2}));
draw('bode.png');

% Maps: numbers of a field, of a plane, of a column; regimes; basins.
axes_of = 'x: {parameter: omega, from: 1.0, to: 4.0, points: 5}, y: {parameter: kappa, values: [5, 10, 20]}';
text = regexprep(good, '  sweep: [^\n]*', ['  map: {' axes_of '}']);
map = whirl_run(text, 'progress', false);
handle = whirl_plot_map(map, 1, 'orbit/max_radius', 'disc');
colours = get(handle(1), 'facevertexcdata');
[~, dark] = min(map.map.orbit.max_radius'(:));
assert(size(colours), [15, 3]);
assert(colours(dark, :), [hex2dec('44'), hex2dec('01'), hex2dec('54')] / 255, 1e-9);   % the scale's first colour
bar = getappdata(gca(), 'whirl_scale');
assert(~isempty(strfind(get(get(bar, 'ylabel'), 'string'), '(m 0-p)')));
draw('map-numbers.png');
place = get(gca(), 'position');
whirl_plot_map(map, 1, 'orbit/max_radius');
narrow = get(gca(), 'position');
whirl_plot_map(map, 1, 'orbit/max_radius');
assert(get(gca(), 'position'), narrow, 1e-9);
assert(narrow(3) < place(3));
whirl_plot_map(map);
assert(get(gca(), 'position'), place, 1e-9);
draw('map.png');
assert(~isempty(whirl_plot_map(map, [], 'orbit/high', 1, 'column', 'y')));
assert(~isempty(whirl_plot_map(map, [], 'rub/max_force', 'rub at disc')));
third = strrep(strrep(text, 'eccentricity: 0.9 m', 'eccentricity: = e'), 'kappa: 10', sprintf('kappa: 10\n  e: 0.9 m'));
planes = whirl_run(strrep(third, axes_of, [axes_of ', z: {parameter: e, values: [0.8, 0.9]}']), 'progress', false);
seen = {};
for plane = 1:2
  handle = whirl_plot_map(planes, plane, 'orbit/max_radius');
  seen{plane} = get(handle(1), 'facevertexcdata');
end
assert(~isequal(seen{1}, seen{2}));
basin_case = regexprep(several, '  (starts|sweep): [^\n]*\n', '');
basin = whirl_run(sprintf(['%s  initial: {disc: {x: = x0, y: = y0, vx: = -y0, vy: = x0}}\n' ...
  '  basin: {x: {parameter: x0, from: -2, to: 2, points: 5}, y: {parameter: y0, from: -1, to: 2, points: 4}}\n'], ...
  basin_case), 'progress', false);
assert(~isempty(whirl_plot_map(basin)));
draw('basin.png');

wrong(@() whirl_plot_orbit(result, 32), 'from 1 to 9');
wrong(@() whirl_plot_orbit(result, 1.5), 'from 1 to 9');
wrong(@() whirl_plot_orbit(result, 3, 'dsic'), 'one of: disc');
wrong(@() whirl_plot_orbit(result, 3, 'disc', 'at', 2), 'not by both');
wrong(@() whirl_plot_orbit(map, 1), 'add waveform to what the case analyses');
wrong(@() whirl_plot_poincare(result, 'at', '1 rpm'), 'omega is ''1 rpm'', expected ');
wrong(@() whirl_plot_poincare(result, 'at', 1e6), 'omega is ''1000000'', expected ');
wrong(@() whirl_plot_poincare(result, 'at', '2 kg'), 'expected a unit of rad/s');
wrong(@() whirl_plot_poincare(result, 'at', '1.2.3 rad/s'), 'expected a number');
wrong(@() whirl_plot_poincare(result, 'at', NaN), 'expected a number');
wrong(@() whirl_plot_poincare(result, 'at', {1}), '''at'' takes a value of the parameter');
wrong(@() whirl_plot_poincare(result, 'at'), '''at'' has no value');
wrong(@() whirl_plot_poincare(result, 3, 'disc', 'color', 'r'), 'argument 4 is no option, expected one of: at table');
wrong(@() whirl_plot_poincare(result, 3, 'disc', 'table', 'map'), 'expected one of: sweep');
wrong(@() whirl_plot_bifurcation(result, 'disc', 'z'), 'one of: x y vx vy');
wrong(@() whirl_plot_bifurcation(result, 'disc', 'x', 'table', 'map'), 'expected one of: sweep');
wrong(@() whirl_plot_spectrum(result, 3, 'disc', 'full', 'no'), 'true or false');
wrong(@() whirl_plot_spectrum(result, 3, 'disc', 'full', false), 'spectrum/amplitude');
wrong(@() whirl_plot_waterfall(result, 'disc', 'highest_order', -1), 'above 0');
wrong(@() whirl_plot_shares(result), 'starts: {count');
wrong(@() whirl_plot_bode(result), 'study: {unbalance: {parameter');
wrong(@() whirl_plot_campbell(3), 'expected a result');
wrong(@() whirl_plot_branches(branch, 'disc', 'vx'), 'one of: x y');
wrong(@() whirl_plot_map(map, 2), 'expected one of: 1');
wrong(@() whirl_plot_map(planes, 3), 'expected one of: 1 2');
wrong(@() whirl_plot_map(planes, 1.5), 'expected one of: 1 2');
wrong(@() whirl_plot_map(map, 1, 'orbit/radius'), 'no such field');
wrong(@() whirl_plot_map(map, 1, 'orbit/max_radius', 'seal'), 'one of: disc');
wrong(@() whirl_plot_map(map, 1, 'rub/max_force', 'seal'), 'one of: rub at disc');
wrong(@() whirl_plot_map(map, 1, 'orbit/high', 'disc', 'column', 'z'), 'one of: x y');
wrong(@() whirl_plot_map(map, 1, 'poincare/section'), 'rows at every point');
wrong(@() whirl_plot_map(map, 'table', 'basin'), 'no such map');
without = result;
without.attributes = rmfield(without.attributes, 'file');
wrong(@() whirl_plot_bifurcation(without), 'which this result does not name');
disp('all well');
