function handle = whirl_plot_spectrum(result, varargin)
% WHIRL_PLOT_SPECTRUM  Draws the spectrum of a point over the order: forward and backward whirl.
%   WHIRL_PLOT_SPECTRUM(RESULT, POINT, STATION) draws forward whirl at orders above 0 and backward whirl below; POINT
%   counts from 1, STATION is a name or a number. The options 'at', VALUE and 'table', NAME are as in WHIRL_PLOT_ORBIT.
%   WHIRL_PLOT_SPECTRUM(..., 'full', false) draws the spectra of x and y, which a result has if the case keeps whole
%   spectra, as for points in detail.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_WATERFALL.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('full', true, 'at', [], 'table', []));
if ~((islogical(options.full) || isnumeric(options.full)) && numel(options.full) == 1)
    error('whirl:badInput', 'the option ''full'' is true or false');
end
field = FIELD.spectrum_amplitude;
panel = 'spectrum';
if options.full
    field = FIELD.spectrum_lines;
    panel = 'full-spectrum';
end
handle = draw_point(result, places, options, field, 'spectrum', panel);
end
