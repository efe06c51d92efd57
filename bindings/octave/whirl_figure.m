function drawn = whirl_figure(file, varargin)
% WHIRL_FIGURE  Draws a figure of a result as reports show it: its panels, units, colours, ticks and legend.
%   WHIRL_FIGURE(FILE) draws the first figure of the result FILE (.h5, or a struct of WHIRL_READ), except the drawing of
%   the machine, into the current figure window, which is cleared. FILE may also be a measured record of a run-up or
%   coast-down (.csv; guide, chapter 16). WHIRL_FIGURE(..., 'with', FILE2) draws the same figure of another result or
%   record into this one, dashed. WHIRL_FIGURE(FILE, NAME) draws the figure NAME; WHIRL_FIGURE(FILE, 'list') prints all
%   names, and NAMES = WHIRL_FIGURE(FILE, 'list') returns them. WHIRL_FIGURE(..., 'panels', 'x,exponent') draws only
%   these panels; 'units', 'um, rpm' uses these units; 'log', 'xy' makes both axes logarithmic; 'columns',
%   'time [s]=t; keyphasor=key; de x [um]=X[:, 0]; de y [um]=X[:, 1]' chooses columns of a measured file.
%
%   DRAWN = WHIRL_FIGURE(...) is a struct: figure and axes (handles, one for each panel), legend and scale (handles of
%   their axes, empty without them), and data, the description of docs/figures.md.
%
%   Errors: whirl:badInput for a file that is no result, and for a wrong name or option; whirl:noCommand.
%
%   See also WHIRL_READ, WHIRL_PLOT_BIFURCATION.
if nargin > 0 && isstruct(file)
    result = result_of(file);
    file = result.attributes.file;
end
if nargin < 1 || ~is_text(text_of(file))
    error('whirl:badInput', 'whirl_figure takes the name of a result file, or what whirl_read gives');
end
named = struct('panels', '', 'units', '', 'log', '', 'with', '', 'columns', '');
[places, options] = arguments_of(varargin, {''}, named);
arguments = ['figure ' quoted(file_of(text_of(file)))];
if strcmp(places{1}, 'list')
    listing = answer([arguments ' --list' given(options)]);
    if nargout == 0
        fprintf('%s', listing);
    else
        drawn = regexp(listing, '^\S+', 'match', 'lineanchors')';
    end
    return
end
if ~isempty(places{1}) && ~is_text(text_of(places{1}))
    error('whirl:badInput', 'the name of a figure is a text: whirl_figure(RESULT, ''list'') gives them');
end
if ~isempty(places{1})
    arguments = [arguments ' ' quoted(file_of(places{1}))];
end
drawn = draw_description(jsondecode(answer([arguments ' -o -' given(options)])));
end

function words = given(options)
% Returns the options for the command.
words = '';
names = fieldnames(options);
for i = 1:numel(names)
    value = text_of(options.(names{i}));
    if ~isempty(value)
        words = [words ' ' quoted(['--' names{i} '=' value])]; %#ok<AGROW>
    end
end
end
