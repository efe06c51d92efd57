function handle = draw_panel_of(result, name, panel, titled)
% DRAW_PANEL_OF  Draws a panel of a figure of a result into the current axes; TITLED with the figure's title.
%   Gives the handles of what is drawn, one a series of docs/figures.md.
data = jsondecode(answer(['figure ' quoted(file_of(result.attributes.file)) ' ' quoted(file_of(name)) ...
    ' --panels=' quoted(panel) ' -o -']));
handle = draw_description(data, newplot(), nargin > 3 && titled);
end
