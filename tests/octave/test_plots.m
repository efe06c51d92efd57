% Figures of sweeps, spectra, branches and machines at rest have the numbers of the result, in the units of the case.
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
function list = points_of(handles)   % all points of lines, sorted
  list = zeros(0, 2);
  for handle = handles(:)'
    list = [list; get(handle, 'xdata')(:), get(handle, 'ydata')(:)];
  end
  list = sortrows(list);
end
function colours = told()   % the colours of verdicts, as docs/guide has them
  colours = containers.Map({'P-1', 'P-2', 'P-4', 'quasi-periodic', 'chaotic', 'undetermined', 'diverged'}, ...
    {'366EFB', '1FBADD', '1D7257', 'CC0892', '000000', '9A9F95', 'FB8D41'});
end
function text = hexadecimal(rgb)
  text = sprintf('%02X', round(255 * rgb));
end
figure('visible', 'off');
good = fileread([getenv('TESTS') '/cli/good.yaml']);
waves = regexprep(good, '  analyze: .*', ...
  "  keep: {waveform: 4}\n  analyze: [poincare, regime, lyapunov, spectrum, orbit, waveform]\n");
waves = strrep(waves, 'points: 5', 'points: 31');
result = whirl_run(strrep(waves, 'transient: 20, record: 10', 'transient: 150, record: 64'), 'progress', false);
sweep = result.sweep;

% Bifurcation diagram: all points, and those of each verdict in its colour.
handle = whirl_plot_bifurcation(result, 'disc', 'y');
section = squeeze(sweep.poincare.section(:, 1, :, 2));
parameter = repmat(sweep.values, 1, size(section, 2));
assert(points_of(handle), sortrows([parameter(:), section(:)]));
names = legend_names();
assert(numel(names) == numel(handle) && numel(handle) > 2);
for i = 1:numel(handle)
  own = strcmp(sweep.verdict.name, names{i});
  if strcmp(names{i}, 'other P-k')
    own = strncmp(sweep.verdict.name, 'P-', 2) & ~ismember(sweep.verdict.name, {'P-1', 'P-2', 'P-4'});
    assert(hexadecimal(get(handle(i), 'color')), '664406');
  else
    assert(hexadecimal(get(handle(i), 'color')), told()(names{i}));
  end
  assert(unique(get(handle(i), 'xdata')(:)), sweep.values(own));
end
labels('omega (rad/s)', 'y of disc (m)');
draw('bifurcation.png');
assert(points_of(whirl_plot_bifurcation(result, 1, 2)), points_of(whirl_plot_bifurcation(result, 'disc', 'y')));
velocity = squeeze(sweep.poincare.section(:, 1, :, 3));
assert(points_of(whirl_plot_bifurcation(result, [], 'vx')), sortrows([parameter(:), velocity(:)]));
labels('omega (rad/s)', 'vx of disc (m) per radian');
bare = rmfield(result, 'sweep');
bare.sweep = rmfield(sweep, 'regime');
fields = sweep.attributes.fields;
bare.sweep.attributes.fields = fields(cellfun(@isempty, strfind(fields, 'regime/')));
handle = whirl_plot_bifurcation(bare);
assert(numel(handle) == 1 && isequal(get(handle, 'color'), [0 0 0]));

% Exponents with their errors.
handle = whirl_plot_lyapunov(result);
assert(points_of(handle(:, 1)), [sweep.values, sweep.lyapunov.largest]);
ends = points_of(handle(:, 2));
ends = ends(~isnan(ends(:, 1)), :);
exponent = sweep.lyapunov.largest;
bars = [sweep.values, exponent - sweep.lyapunov.error; sweep.values, exponent + sweep.lyapunov.error];
assert(ends, sortrows(bars), 1e-15);
assert(legend_names(), names);
labels('omega (rad/s)', 'largest exponent (1/revolution)');
draw('lyapunov.png');

% One point: by its number, by a value, by a text.
for call = {@() whirl_plot_poincare(result, 16, 1), @() whirl_plot_poincare(result, [], 1, 'at', 2.53), ...
    @() whirl_plot_poincare(result, 'at', '2.5 rad/s')}
  handle = call{1}();
  assert([get(handle, 'xdata')(:), get(handle, 'ydata')(:)], squeeze(sweep.poincare.section(16, 1, :, 1:2)));
end
assert(get(get(gca(), 'title'), 'string'), ['omega = 2.5 rad/s: ' sweep.verdict.name{16}]);
labels('x of disc (m)', 'y of disc (m)');
draw('poincare.png');
handle = whirl_plot_orbit(result, 29, 'disc');
path = squeeze(sweep.waveform.samples(29, 1, :, 1:2));
assert([get(handle(1), 'xdata')(:), get(handle(1), 'ydata')(:)], path);
marks = [get(handle(2), 'xdata')(:), get(handle(2), 'ydata')(:)];
assert(size(marks), [4 2]);
for i = 1:3   % the last revolution ends one sample beyond the path
  assert(min(max(abs(path - marks(i, :)), [], 2)) < 1e-12);
end
labels('x of disc (m)', 'y of disc (m)');
draw('orbit.png');

% Spectra: forward above zero, backward below.
lines_of = squeeze(sweep.spectrum.lines(29, 1, :, :));
lines_of = lines_of(~isnan(lines_of(:, 1)), :);
tips = @(handle) [get(handle, 'xdata')(2:3:end)(:), get(handle, 'ydata')(2:3:end)(:)];
handle = whirl_plot_spectrum(result, 29);
assert(tips(handle(1)), lines_of(:, [1 4]));
assert(tips(handle(2)), [-lines_of(:, 1), lines_of(:, 5)]);
assert(get(handle(1), 'ydata')(1:3:end)(:), zeros(size(lines_of, 1), 1));
labels('order, backward below 0', 'amplitude of disc (m 0-p)');
draw('spectrum.png');
handle = whirl_plot_spectrum(result, 29, 'disc', 'full', false);
assert(tips(handle), lines_of(:, 1:2));
labels('order', 'amplitude of disc (m 0-p)');
all_lines = reshape(sweep.spectrum.lines(:, 1, :, :), [], 5);
at = repmat(sweep.values, size(sweep.spectrum.lines, 3), 1);
expected = [all_lines(:, 1), at, all_lines(:, 4); -all_lines(:, 1), at, all_lines(:, 5)];
expected = sortrows(expected(expected(:, 3) > 1e-3 * max(expected(:, 3)), :));
handle = whirl_plot_waterfall(result);
drawn = sortrows([get(handle, 'xdata')(:), get(handle, 'ydata')(:), 10.^get(handle, 'cdata')(:)]);
assert(size(drawn, 1) > 100);
assert(drawn, expected, 1e-12);
labels('order, backward below 0', 'omega (rad/s)');
draw('waterfall.png');
handle = whirl_plot_waterfall(result, 'disc', 'full', false, 'highest_order', 1.2);
assert(max(get(handle, 'xdata')) <= 1.2 && min(get(handle, 'xdata')) >= 0);
assert(sum(all_lines(:, 2) > 1e-3 * max(all_lines(:, 2)) & all_lines(:, 1) <= 1.2), numel(get(handle, 'xdata')));

% Units are those that the case chose; those of reports without a choice: over the scale where it has a name.
own = sprintf(['whirl: 1\nparameters: {speed: 600 rpm, c: 0.2 mm}\nrotor:\n  speed: = speed\n  length_scale: = c\n' ...
  '  stations:\n    disc: {mass: 4 kg, damping: 20 N.s/m, eccentricity: = 0.1*c}\n  elements:\n' ...
  '    - shaft: {between: [disc, ground], k1: 100 kN/m, k2: 100 kN/m}\nstudy:\n' ...
  '  sweep: {parameter: speed, from: 600 rpm, to: 1200 rpm, points: 3}\n' ...
  '  integrate: {method: rk4, steps_per_revolution: 64, transient: 20, record: 10}\n' ...
  '  analyze: [poincare, spectrum]\n']);
choices = {'', 'speed (rpm)', 'x of disc / c', 600, 1, 'amplitude of disc / c (0-p)', 1
  'mm', 'speed (rpm)', 'x of disc (mm)', 600, 0.2, 'amplitude of disc (mm 0-p)', 0.2
  'um, rad/s, p-p', 'speed (rad/s)', 'x of disc (µm)', 20 * pi, 200, 'amplitude of disc (µm p-p)', 400
  'scale, p-p', 'speed (rpm)', 'x of disc / c', 600, 1, 'amplitude of disc / c (p-p)', 2
  'mil', 'speed (rpm)', 'x of disc (mil)', 600, 0.2e-3 / 25.4e-6, 'amplitude of disc (mil 0-p)', 0.2e-3 / 25.4e-6};
for choice = choices'
  text = own;
  if ~isempty(choice{1})
    text = sprintf('%s  units: "%s"\n', own, choice{1});
  end
  chosen = whirl_run(text, 'progress', false);
  drawn = points_of(whirl_plot_bifurcation(chosen));
  labels(choice{2}, choice{3});
  assert(unique(drawn(:, 1)), choice{4} * [1; 1.5; 2], 1e-12 * choice{4});
  section = squeeze(chosen.sweep.poincare.section(:, 1, :, 1));
  assert(sort(drawn(:, 2)), sort(section(:)) * choice{5}, 1e-12);
  handle = whirl_plot_spectrum(chosen, 'at', sprintf('%.17g%s', choice{4} * 1.5, choice{2}(8:end - 1)), 'full', false);
  lines_of = squeeze(chosen.sweep.spectrum.lines(2, 1, :, 1:2));
  assert(tips(handle)(:, 2), lines_of(~isnan(lines_of(:, 1)), 2) * choice{7}, 1e-12);
  labels('order', choice{6});
end
assert(get(get(gca(), 'title'), 'string'), 'speed = 900 rpm');
% The clearance, which is the scale, varies: lengths in mm go by that of each point.
text = strrep(own, 'parameter: speed, from: 600 rpm, to: 1200 rpm', 'parameter: c, from: 0.1 mm, to: 0.3 mm');
scaled = whirl_run(sprintf('%s  units: mm\n', text), 'progress', false);
drawn = points_of(whirl_plot_bifurcation(scaled));
section = squeeze(scaled.sweep.poincare.section(:, 1, :, 1)) .* (scaled.sweep.length_scale * 1e3);
assert(sort(drawn(:, 2)), sort(section(:)), 1e-12);
assert(scaled.sweep.length_scale, [1e-4; 2e-4; 3e-4], 1e-18);
labels('c (mm)', 'x of disc (mm)');

% Several starts: every attractor once a place; shares are counted here from the starts that are no neighbours.
several = fileread([getenv('TESTS') '/octave/several_starts.yaml']);
starts = whirl_run(several, 'progress', false);
sweep = starts.sweep;
handle = whirl_plot_bifurcation(starts);
assert(numel(handle), double(max(sweep.attractor)));
assert(legend_names(), {'attractor 1', 'attractor 2'});
for number = 1:numel(handle)
  places = unique(sweep.values(sweep.attractor == number));
  assert(get(handle(number), 'xdata')(:), repmat(places, size(sweep.poincare.section, 3), 1));
  drawn = reshape(get(handle(number), 'ydata'), numel(places), []);
  for i = 1:numel(places)
    first = find(sweep.attractor == number & sweep.values == places(i), 1);
    assert(drawn(i, :)(:), squeeze(sweep.poincare.section(first, 1, :, 1)));
  end
end
draw('bifurcation-starts.png');
handle = whirl_plot_shares(starts);
labels('omega (rad/s)', 'share of the starts (%)');
for number = 1:2
  for place = unique(sweep.values(sweep.attractor == number))'
    of_place = sweep.values == place & sweep.starts.neighbour == 0;
    share = 100 * mean(sweep.attractor(of_place) == number);
    column = 1 + (share == 0);
    at = find(get(handle(number, column), 'xdata') == place);
    assert(get(handle(number, column), 'ydata')(at), share, 1e-12);
    if share > 0
      bar = get(handle(number, 3), 'ydata')(find(get(handle(number, 3), 'xdata') == place))(:);
      error_size = sqrt(share * (100 - share) / sum(of_place));
      assert(bar, share + [-1; 1] * error_size, 1e-9);
    end
  end
end
draw('shares.png');
found = starts;   % had none of the place's own starts led to the second attractor at 180 rad/s
found.sweep.share(sweep.attractor == 2 & sweep.values == 180) = 0;
handle = whirl_plot_shares(found);
assert([get(handle(2, 2), 'xdata'), get(handle(2, 2), 'ydata')], [180, 0]);
assert(get(handle(2, 2), 'markerfacecolor'), 'none');
assert(get(handle(2, 1), 'xdata')(:), [220; 260]);
unsure = starts;
unsure.sweep.attractor(find(sweep.values == 260, 3)) = 0;   % motions without a verdict are like no other
handle_of_unsure = whirl_plot_lyapunov(unsure);
assert(legend_names(), {'attractor 1', 'attractor 2', 'no verdict'});
assert(get(handle_of_unsure(3, 1), 'xdata')(:), [260; 260; 260]);
handle = whirl_plot_lyapunov(starts);
assert(legend_names(), {'attractor 1', 'attractor 2'});
assert(numel(unique(sweep.values(sweep.attractor == 2))), numel(get(handle(2, 1), 'xdata')));

% Branches: dashed where they are unstable, marks by what special points are, with their values.
branch = whirl_run([getenv('TESTS') '/cli/branch.yaml'], 'progress', false);
trace = branch.branch.trace;
handle = whirl_plot_branches(branch, 'disc', 'y');
high = trace.high(:, 1, 2);
is_line = ~strcmp(get(handle, 'linestyle'), 'none');
dashed = handle(strcmp(get(handle, 'linestyle'), '--'));
solid = handle(strcmp(get(handle, 'linestyle'), '-'));
unstable = trace.unstable > 0;
all_points = [branch.branch.values, high];
assert(all(ismember(all_points(unstable, :), points_of(dashed), 'rows')) && any(unstable));
assert(all(ismember(all_points(~unstable, :), points_of(solid), 'rows')));
assert(all(ismember(points_of(handle(is_line)), all_points, 'rows')));
marks = handle(~is_line);
kinds = unique(trace.special(trace.special > 0))';
assert(numel(marks) == numel(kinds) && numel(kinds) > 2);
titles = {'fold', 'crossing', 'period doubling', 'Neimark-Sacker', 'Hopf', 'grazing'};
for i = 1:numel(kinds)
  assert(points_of(marks(i)), sortrows(all_points(trace.special == kinds(i), :)));
end
assert(legend_names(), [{'stable', 'unstable'}, titles(kinds)]);
texts = strtrim(get(findobj(gca(), 'type', 'text', '-and', '-regexp', 'string', '\d'), 'string'));
expected = arrayfun(@(value) sprintf('%.6g', value), branch.branch.values(trace.special > 0), 'UniformOutput', false);
assert(sort(texts), sort(expected));
labels('omega (rad/s)', 'largest y of disc (m)');
draw('branches.png');

% Machines at rest: springs are in tune with the speed where it is sqrt(k/m).
modes = whirl_run([getenv('TESTS') '/cli/modes.yaml'], 'progress', false);
rpm = 2 * pi / 60;
handle = whirl_plot_campbell(modes);
assert(legend_names(), {'neither', '1X', 'critical speed'});
frequency = modes.modes.modes.frequency / rpm;
speed = repmat(modes.modes.values / rpm, 1, 2);
assert(points_of(handle(1)), sortrows([speed(:), frequency(:)]), 1e-9);
assert(points_of(handle(2)), speed, 1e-9);
tuned = sqrt([80e3; 200e3] / 2) / rpm;
assert(points_of(handle(3)), [tuned, tuned], 1e-6);
texts = strtrim(get(findobj(gca(), 'type', 'text', '-and', '-regexp', 'string', '\d'), 'string'));
assert(sort(texts), {'1909.9'; '3019.8'});
labels('omega (rpm)', 'damped frequency (rpm)');
draw('campbell.png');
text = fileread([getenv('CASES') '/ross-example.yaml']);
turning = whirl_run(strrep(text, 'points: 101', 'points: 11'), 'progress', false);
handle = whirl_plot_campbell(turning);
names = legend_names();
direction = turning.modes.modes.direction;
frequency = turning.modes.modes.frequency / rpm;
assert(sortrows([names(1:2); {'^', 'v'}]')', [{'backward', 'forward'}; {'v', '^'}]);
speed = repmat(turning.modes.values / rpm, 1, columns(frequency));
forward = direction > 0.05;
assert(points_of(handle(strcmp(names, 'forward'))), sortrows([speed(forward), frequency(forward)]), 1e-7);
assert(get(handle(strcmp(names, 'backward')), 'marker'), 'v');
assert(get(handle(strcmp(names, 'forward')), 'marker'), '^');
assert(numel(get(handle(strcmp(names, 'backward')), 'xdata')), sum(direction(:) < -0.05));
draw('campbell-turning.png');
text = fileread([getenv('TESTS') '/cli/modes.yaml']);
text = [text(1:strfind(text, 'study:') - 1) ...
  sprintf('study:\n  unbalance: {parameter: omega, from: 500 rpm, to: 4000 rpm, points: 36}\n  units: um, p-p\n')];
response = whirl_run(text, 'progress', false);
handle = whirl_plot_bode(response, 'disc');
turns = get(handle(1, 1), 'xdata')(:) * rpm;
assert(numel(turns), 36);
assert(get(handle(1, 1), 'ydata')(:), 20 * turns.^2 ./ abs(80e3 / 2 - turns.^2), 1e-7);   % 2 e r^2/(1 - r^2), e = 10 um
assert(get(handle(1, 2), 'ydata')(:), 20 * turns.^2 ./ abs(200e3 / 2 - turns.^2), 1e-7);
assert(get(handle(2, 1), 'ydata')(:), 180 * (turns.^2 > 80e3 / 2), 1e-9);
labels('omega (rpm)', 'lag (degrees)');
assert(get(get(get(handle(1, 1), 'parent'), 'ylabel'), 'string'), 'amplitude of disc (µm p-p)');
draw('bode.png');
response.unbalance.unbalance.lag(20:end, 1, 2) = response.unbalance.unbalance.lag(20:end, 1, 2) + 200;
handle = whirl_plot_bode(response);
lag = get(handle(2, 2), 'ydata')(:);
assert(find(isnan(lag)), 20);
assert(lag([1:19, 21:end]), response.unbalance.unbalance.lag(:, 1, 2));
close('all');
figure('visible', 'off');

% A figure takes the place of the one before, unless that is held.
whirl_plot_poincare(result, 3);
whirl_plot_poincare(result, 4);
assert(numel(get(gca(), 'children')), 1);
hold('on');
whirl_plot_poincare(result, 5);
assert(numel(get(gca(), 'children')) == 2 && ishold());
hold('off');

% A single point stands over its number.
single = whirl_run(regexprep(good, '  sweep: [^\n]*', '  response: {}'), 'progress', false);
section = squeeze(single.response.poincare.section(1, 1, :, 1));
assert(points_of(whirl_plot_bifurcation(single)), sortrows([ones(size(section)), section]));
labels('point', 'x of disc (m)');
handle = whirl_plot_poincare(single);
assert(get(handle, 'xdata')(:), section);
assert(get(get(gca(), 'title'), 'string'), ['response: ' single.response.verdict.name{1}]);
wrong(@() whirl_plot_poincare(single, 'at', 1.5), 'nothing varies in the table ''response''');

wrong(@() whirl_plot_orbit(result, 32), 'from 1 to 31');
wrong(@() whirl_plot_orbit(result, 1.5), 'from 1 to 31');
wrong(@() whirl_plot_orbit(result, 3, 'dsic'), 'one of: disc');
wrong(@() whirl_plot_orbit(result, 3, 'disc', 'at', 2), 'not by both');
wrong(@() whirl_plot_poincare(result, 'at', '2 rpm'), 'unit of the figure, ''1 rad/s''');
wrong(@() whirl_plot_poincare(result, 'at', '1.2.3 rad/s'), 'unit of the figure');
wrong(@() whirl_plot_poincare(result, 'at', NaN), 'unit of the figure');
wrong(@() whirl_plot_poincare(result, 'at'), '''at'' has no value');
wrong(@() whirl_plot_poincare(result, 3, 'disc', 'color', 'r'), 'argument 4 is no option, expected one of: at table');
wrong(@() whirl_plot_poincare(result, 3, 'disc', 'table', 'map'), 'expected one of: sweep');
wrong(@() whirl_plot_bifurcation(result, 'disc', 'z'), 'one of: x y vx vy');
wrong(@() whirl_plot_spectrum(result, 3, 'disc', 'full', 'no'), 'true or false');
wrong(@() whirl_plot_waterfall(result, 'disc', 'highest_order', -1), 'above 0');
wrong(@() whirl_plot_shares(result), 'starts: {count');
wrong(@() whirl_plot_bode(result), 'add unbalance to what the case analyses');
wrong(@() whirl_plot_campbell(3), 'expected a result');
wrong(@() whirl_plot_branches(branch, 'disc', 'vx'), 'one of: x y');
disp('all well');
