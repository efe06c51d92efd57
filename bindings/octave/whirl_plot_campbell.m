function handle = whirl_plot_campbell(result)
% WHIRL_PLOT_CAMPBELL  Draws the Campbell diagram of a result with modes: natural frequencies over the speed.
%   WHIRL_PLOT_CAMPBELL(RESULT) draws the damped frequencies in rad/s and the line of the speed itself. Gives the
%   handles.
%
%   See also WHIRL_READ.
table = table_with(result, 'modes', {'modes', 'response', 'sweep'});
speed = table.modes.speed(:);
handle = plot(speed, table.modes.frequency, 'b-', speed, speed, 'k--');
xlabel('speed in rad/s');
ylabel('frequency in rad/s');
title('Campbell diagram');
end
