% Every figure has the numbers of the result, and is drawn.
warning('off', 'all');   % Octave discourages from gnuplot, which draws without a screen
graphics_toolkit('gnuplot');
figure('visible', 'off');
function draw(name)
  print('-dpngcairo', name);
  found = dir(name);
  assert(numel(found) == 1 && found.bytes > 1500);
end

good = fileread([getenv('TESTS') '/cli/good.yaml']);
waves = regexprep(good, '  analyze: .*', "  keep: {waveform: 4}\n  analyze: [poincare, regime, spectrum, orbit, waveform]\n");
waves = strrep(waves, 'points: 5', 'points: 31');
result = whirl_run(waves, 'progress', false);

handle = whirl_plot_bifurcation(result, 'disc', 2);
section = squeeze(result.sweep.poincare.section(:, 1, :, 2));
assert(get(handle, 'ydata')(:), section(:));
assert(get(handle, 'xdata')(1:31)(:), result.sweep.values);
draw('bifurcation.png');
handle = whirl_plot_orbit(result, 3, 'disc');
assert(get(handle, 'xdata')(:), squeeze(result.sweep.waveform.samples(3, 1, :, 1)));
draw('orbit.png');
handle = whirl_plot_poincare(result, 31, 1);
assert(get(handle, 'ydata')(:), squeeze(result.sweep.poincare.section(31, 1, :, 2)));
draw('poincare.png');
handle = whirl_plot_spectrum(result, 3);
lines = squeeze(result.sweep.spectrum.lines(3, 1, :, :));
assert(get(handle, 'ydata')(:), lines(~isnan(lines(:, 1)), 2));
draw('spectrum.png');
failed = false;
try
  whirl_plot_orbit(result, 32);
catch problem
  failed = ~isempty(strfind(problem.message, 'from 1 to 31'));
end
assert(failed);

modes = whirl_run([getenv('TESTS') '/cli/modes.yaml'], 'progress', false);
handle = whirl_plot_campbell(modes);
assert(get(handle(1), 'ydata')(:), modes.modes.modes.frequency(:, 1));
draw('campbell.png');
branch = whirl_run([getenv('TESTS') '/cli/branch.yaml'], 'progress', false);
clf();
handle = whirl_plot_branches(branch);
assert(get(handle(1), 'ydata')(1), branch.branch.trace.high(1, 1, 1));
draw('branches.png');
long = strrep(good, 'transient: 20, record: 10', 'transient: 150, record: 64');
map = whirl_run(regexprep(long, '  sweep: [^\n]*', ...
  '  map: {x: {parameter: omega, from: 1.0, to: 4.0, points: 9}, y: {parameter: kappa, from: 5, to: 20, points: 7}}'), ...
  'progress', false);
clf();
handle = whirl_plot_map(map);
assert(double(get(handle, 'cdata')), double(map.map.regime.code));
assert(size(map.map.regime.code), [7 9]);
assert(numel(unique(map.map.regime.code)) > 1);
draw('map.png');
third = strrep(strrep(long, 'eccentricity: 0.9 m', 'eccentricity: = e'), 'kappa: 10', sprintf('kappa: 10\n  e: 0.9 m'));
planes = whirl_run(regexprep(third, '  sweep: [^\n]*', ...
  ['  map: {x: {parameter: omega, from: 1.0, to: 4.0, points: 9}, y: {parameter: kappa, from: 5, to: 20, points: 7}, ' ...
   'z: {parameter: e, values: [0.8, 0.9]}}']), 'progress', false);
handle = whirl_plot_map(planes, 2);
assert(double(get(handle, 'cdata')), double(map.map.regime.code));
disp('all well');
