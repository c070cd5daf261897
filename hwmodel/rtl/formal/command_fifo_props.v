// What a queue always does: the k-th entry put in is the k-th taken out, for any k.
module command_fifo_props #(
    // bits of an entry
    parameter N = 24
) (
    input wire         clk,
    input wire         valid,
    input wire [N-1:0] data,
    input wire         ready
);
    localparam LOG_DEPTH = 2;
    localparam DEPTH     = 1 << LOG_DEPTH;

    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire               in_ready, out_valid;
    wire [N-1:0]       head;
    wire [LOG_DEPTH:0] write, read;
    wire [DEPTH*N-1:0] entries;

    command_fifo #(.WIDTH(N), .LOG_DEPTH(LOG_DEPTH)) fifo (
        .i_clk(clk), .i_rst(first), .i_valid(valid), .i_data(data), .o_ready(in_ready),
        .o_valid(out_valid), .o_data(head), .i_ready(ready), .o_entries(entries),
        .o_write(write), .o_read(read)
    );

    // Entries put in and taken out, and the k-th one. The counts wrap far beyond the depth, so
    // one k stands for every 256th.
    (* anyconst *) reg [7:0] k;
    reg [7:0]   puts = 0, takes = 0;
    reg [N-1:0] kth;
    always @(posedge clk)
        if (first) begin
            puts  <= 0;
            takes <= 0;
        end else begin
            if (valid & in_ready) puts <= puts + 1'b1;
            if (out_valid & ready) takes <= takes + 1'b1;
            if (valid & in_ready & puts == k) kth <= data;
        end

    wire [7:0] inside = puts - takes;
    wire [7:0] ahead  = k - takes;

    always @* if (!first) begin
        if (out_valid & takes == k) assert (head == kth);
        // Never more than there is room for; something to take and room to put whenever there is.
        assert (inside <= DEPTH);
        assert (out_valid == (inside != 0));
        assert (in_ready == (inside != DEPTH));
        // Where the entries are, for the induction.
        assert (write == puts[LOG_DEPTH:0]);
        assert (read == takes[LOG_DEPTH:0]);
        if (ahead < inside) assert (entries[k[LOG_DEPTH-1:0]*N +: N] == kth);
    end
endmodule
