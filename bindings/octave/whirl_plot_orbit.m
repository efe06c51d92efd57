function handle = whirl_plot_orbit(result, varargin)
% WHIRL_PLOT_ORBIT  Draws the orbit of a station at a point of a study with waveforms.
%   WHIRL_PLOT_ORBIT(RESULT, POINT, STATION) draws y over x, with a mark at every revolution if sections were taken;
%   POINT counts from 1, STATION is a name or a number. The case must ask for waveforms: analyze: [waveform], keep:
%   {waveform: 20}. WHIRL_PLOT_ORBIT(RESULT, [], STATION, 'at', VALUE) draws the point whose parameter is nearest to a
%   value in SI, as in RESULT.sweep.values, or to a text with any unit of the parameter: '600 rpm'. A value that is
%   beyond all points by more than the last step is an error. WHIRL_PLOT_ORBIT(..., 'table', NAME) draws the table NAME,
%   not the first with waveforms.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_POINCARE.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('at', [], 'table', []));
handle = draw_point(result, places, options, FIELD.waveform_samples, 'waveform', 'orbit');
end
