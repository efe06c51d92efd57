function [names, colours] = regimes()
% REGIMES  The classes of verdicts and their colours, those of reports: told apart by readers of any colour vision.
names = {'P-1', 'P-2', 'P-4', 'other P-k', 'quasi-periodic', 'chaotic', 'undetermined', 'diverged'};
colours = colour({'#366EFB', '#1FBADD', '#1D7257', '#664406', '#CC0892', '#000000', '#9A9F95', '#FB8D41'});
end
