% Strings of MATLAB, which are objects, are taken wherever a text is.
warning('off', 'all');   % Octave discourages from gnuplot, which draws without a screen
graphics_toolkit('gnuplot');
figure('visible', 'off');
addpath([getenv('TESTS') '/octave/strings']);
good = fileread([getenv('TESTS') '/cli/good.yaml']);
waves = regexprep(good, '  analyze: .*', ...
  "  keep: {waveform: 4}\n  analyze: [poincare, regime, spectrum, orbit, waveform]\n");
s = @(text) string(text);
assert(isa(s('a'), 'string') && ~ischar(s('a')));

stream = fopen('case.yaml', 'w');
fwrite(stream, waves);
fclose(stream);
plain = whirl_run('case.yaml', 'kappa', '12', 'progress', false, 'output', 'plain.h5');
result = whirl_run(s('case.yaml'), s('kappa'), s('12'), s('progress'), false, s('output'), s('strings.h5'));
assert(result.parameters.value, [1.5; 12]);
assert(result.sweep.poincare.section, plain.sweep.poincare.section);
assert(isequaln(whirl_read(s('strings.h5')), result));
from_text = whirl_run(s(waves), 'kappa', 12, 'progress', false);
assert(from_text.sweep.values, plain.sweep.values);

y = @(handle) get(handle(1), 'ydata')(:);
assert(y(whirl_plot_poincare(s('strings.h5'), 3, s('disc'))), y(whirl_plot_poincare(plain, 3, 'disc')));
assert(y(whirl_plot_poincare(result, [], [], s('at'), s('2.5 rad/s'))), y(whirl_plot_poincare(plain, 3)));
assert(y(whirl_plot_orbit(result, 3, s('disc'), s('table'), s('sweep'))), y(whirl_plot_orbit(plain, 3)));
assert(y(whirl_plot_bifurcation(result, s('disc'), s('y'))), y(whirl_plot_bifurcation(plain, 'disc', 'y')));
assert(y(whirl_plot_spectrum(result, 3, s('disc'), s('full'), true)), ...
  y(whirl_plot_spectrum(plain, 3, 'disc', 'full', true)));
assert(y(whirl_plot_waterfall(result, s('disc'), s('highest_order'), 2)), y(whirl_plot_waterfall(plain, 'disc')));

m = whirl_machine(s('case.yaml'), s('kappa'), s('12'));
x = [1.2; 0.9; 0.3; -0.2];
assert(whirl_element(s('rub'), m, 0.7, x), whirl_element('rub', m, 0.7, x));
whirl_machine(s('clear'), m);
clear whirl_mex;
disp('all well');
