function keep_file(file)
% KEEP_FILE  Keeps a temporary result file, from which figures are drawn, until eight more are kept or the session ends.
persistent kept
if isempty(kept)
    kept = {};
end
kept{end + 1} = onCleanup(@() delete(file));
if numel(kept) > 8
    kept(1) = [];
end
end
