function handle = whirl_plot_shares(result, varargin)
% WHIRL_PLOT_SHARES  Draws the share of the starts that leads to each attractor, over the parameter.
%   WHIRL_PLOT_SHARES(RESULT) draws the shares with their standard errors, in the colours of the attractors; open
%   circles mark shares of 0, of attractors that were found only from a neighbouring point. WHIRL_PLOT_SHARES(RESULT,
%   'table', NAME) draws the table NAME, not the first with several starts.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_BIFURCATION, WHIRL_PLOT_MAP.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
result = result_of(result);
[table, name] = table_with(result, FIELD.poincare_section, 'poincare', options.table);
if ~isfield(table, 'attractor')
    error('whirl:badInput', ['points of the table ''%s'' have one start: ' ...
        '''study: {starts: {count: ..., within: ...}}'' in a case gives them several'], name);
end
handle = draw_panel_of(result, figure_name(result, 'bifurcation', '', name, []), 'share');
end
